//! Requests about a model in memory.

use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions};
use percuss_study::{Model, ask, study_keys};

#[test]
fn every_output_file_is_refused() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/point_mass_pendulum.urdf");
    let model = Model::load(path, DEFAULT_MAX_SIZE, &LoadOptions::default()).expect("a model");
    let keys: Vec<String> = study_keys().into_iter().filter(|key| key.ends_with(".output")).collect();
    for key in &keys {
        let (table, last) = key.split_once('.').expect("a table and a key");
        let request = format!("{{\"{table}\": {{\"{last}\": \"file.csv\"}}}}");
        let message = ask(&model, &request).expect_err(key).message();
        assert!(message.starts_with(&format!("{key}: a request writes no file")), "{message}");
    }
    assert_eq!(keys.len(), 4, "{keys:?}");
}
