//! Every example program runs and keeps what it asserts.

#[path = "../examples/01_heated_ball.rs"]
mod heated_ball;

#[test]
fn heated_ball() {
    heated_ball::main().unwrap();
}
