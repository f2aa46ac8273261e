//! Every example program runs and keeps what it asserts.

#[path = "../examples/01_heated_ball.rs"]
mod heated_ball;

#[path = "../examples/02_blended_cylinder.rs"]
mod blended_cylinder;

#[test]
fn heated_ball() {
    heated_ball::main().unwrap();
}

#[test]
fn blended_cylinder() {
    blended_cylinder::main().unwrap();
}
