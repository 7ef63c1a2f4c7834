//! Shared helpers of the tests of this crate.
#![allow(dead_code, reason = "each test binary uses a part")]

use percuss_formats::{Diagnostic, LoadError, LoadOptions, Loaded, Source, load};
use percuss_mechanism::Severity;

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
