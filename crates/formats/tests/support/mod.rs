//! Shared helpers of the tests of this crate.
#![allow(dead_code, reason = "each test binary uses a part")]

use cpu_time::ThreadTime;
use percuss_formats::{
    Diagnostic, LoadError, LoadOptions, Loaded, MemoryFiles, Source, load, load_file, write_urdf,
};
use percuss_mechanism::Severity;
use std::path::PathBuf;
use std::time::Duration;

/// Largest processor time of a hostile file: less than a second is usual, and quadratic work would exceed the limit by far.
const PATIENCE: Duration = Duration::from_secs(20);

/// Result of `work`, which takes at most [`PATIENCE`] of the processor time of this thread.
pub fn bounded<T>(what: &str, work: impl FnOnce() -> T) -> T {
    let start = ThreadTime::now();
    let result = work();
    assert!(start.elapsed() < PATIENCE, "{what} took {:?}", start.elapsed());
    result
}

/// Pendulum of 2 kg at a height of 1 m.
pub const PENDULUM: &str = r#"<?xml version="1.0"?>
<robot name="pendulum">
  <link name="base"/>
  <joint name="hinge" type="revolute">
    <origin xyz="0 0 1" rpy="0 0 0"/>
    <parent link="base"/>
    <child link="arm"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1.5" effort="10" velocity="3"/>
  </joint>
  <link name="arm">
    <inertial>
      <origin xyz="0 0 -0.5" rpy="0 0 0"/>
      <mass value="2"/>
      <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.12" iyz="0" izz="0.03"/>
    </inertial>
    <visual>
      <origin xyz="0 0 -0.5"/>
      <geometry><cylinder radius="0.3" length="0.8"/></geometry>
    </visual>
  </link>
</robot>
"#;

/// Loads a text.
pub fn load_text(text: &str) -> Result<Loaded, LoadError> {
    load(&Source::from_text("model.urdf", text), &LoadOptions::default())
}

/// Loads the pendulum with some text replaced; each old text must occur.
pub fn changed(changes: &[(&str, &str)]) -> Result<Loaded, LoadError> {
    let mut text = PENDULUM.to_owned();
    for (old, new) in changes {
        assert!(text.contains(old), "the pendulum has no {old}");
        text = text.replacen(old, new, 1);
    }
    load_text(&text)
}

/// Diagnostics of a loaded or a refused file.
pub fn told(loaded: &Result<Loaded, LoadError>) -> &[Diagnostic] {
    match loaded {
        Ok(loaded) => &loaded.diagnostics,
        Err(error) => &error.diagnostics,
    }
}

/// Severity and code of every diagnostic.
pub fn codes(loaded: &Result<Loaded, LoadError>) -> Vec<(Severity, &'static str)> {
    told(loaded).iter().map(|d| (d.severity, d.code)).collect()
}

/// Temporary folder on the disk with a copy of its files in memory; removed at the end.
pub struct Folder(PathBuf, MemoryFiles);

impl Folder {
    /// Folder with these files. `name`: unique among the tests.
    pub fn new(name: &str, files: &[(&str, String)]) -> Self {
        let path = std::env::temp_dir().join(format!("percuss-formats-{name}-{}", std::process::id()));
        for (file, text) in files {
            let file = path.join(file);
            std::fs::create_dir_all(file.parent().expect("a folder")).expect("a folder");
            std::fs::write(file, text).expect("a file");
        }
        let in_memory = files.iter().map(|(file, text)| {
            let name = path.join(file).to_string_lossy().into_owned();
            (name, text.clone().into_bytes())
        });
        let in_memory = MemoryFiles::new(in_memory);
        Self(path, in_memory)
    }

    /// Loads a file of the folder. Asserts that the files in memory give the same mechanism and findings.
    pub fn load(&self, file: &str) -> Result<Loaded, LoadError> {
        let path = self.0.join(file).to_string_lossy().into_owned();
        let loaded = load_file(&path);
        let source = Source::read_from(&self.1.clone().into(), &path, 1 << 20);
        let in_memory = source.and_then(|source| load(&source, &LoadOptions::default()));
        let summary = |loaded: &Result<Loaded, LoadError>| {
            let findings: Vec<_> =
                told(loaded).iter().map(|d| (d.code, d.path.clone(), d.line, d.severity)).collect();
            let parts = loaded.as_ref().ok();
            let parts = parts.map(|loaded| (write_urdf(&loaded.mechanism), &loaded.files, &loaded.shapes));
            format!("{findings:?} {parts:?}")
        };
        assert_eq!(summary(&in_memory), summary(&loaded), "{path}: in memory, and in the file system");
        loaded
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
