//! Every config runs as it is: its expectations are met and near what is measured.
//! Over a million tets, so `cargo test` leaves it to `cargo test --test full_size`.

mod common;

use common::{configs, report, succeed};

#[test]
fn every_config_meets_its_expectations_and_they_are_tight() {
    for config in configs() {
        let folder = tempfile::tempdir().unwrap();
        let path = config.display().to_string();
        succeed(folder.path(), &["run", &path, "--out", "full"]);
        let report = report(&folder.path().join("full"));
        let expectations = report["expectations"].as_array().unwrap();
        assert!(!expectations.is_empty(), "{} expects nothing", config.display());
        for expectation in expectations {
            assert_eq!(expectation["met"], true, "{expectation}");
            let measured = expectation["measured"].as_f64().unwrap();
            for bound in ["min", "max"].iter().filter_map(|key| expectation[key].as_f64()) {
                let distance = (bound - measured).abs();
                assert!(distance <= 0.2 * measured.abs(), "bound too loose: {expectation}");
            }
        }
    }
}
