//! Every example program runs and keeps what it asserts.

#[path = "../examples/02_blended_cylinder.rs"]
mod blended_cylinder;
#[path = "../examples/01_heated_ball.rs"]
mod heated_ball;
#[path = "../examples/03_loaded_bracket.rs"]
mod loaded_bracket;

#[test]
fn heated_ball() {
    heated_ball::main().unwrap();
}

#[test]
fn blended_cylinder() {
    blended_cylinder::main().unwrap();
}

#[test]
fn loaded_bracket() {
    loaded_bracket::main().unwrap();
}
