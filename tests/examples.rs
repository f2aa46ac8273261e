//! Every example program runs and keeps what it asserts.

#[path = "../examples/01_heated_ball.rs"]
mod heated_ball;
#[path = "../examples/02_loaded_bracket.rs"]
mod loaded_bracket;

#[test]
fn heated_ball() {
    heated_ball::main().unwrap();
}

#[test]
fn loaded_bracket() {
    loaded_bracket::main().unwrap();
}
