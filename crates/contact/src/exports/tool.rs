//! The simulators and their names.

/// A simulator that contacts are written for.
#[derive(Clone, Copy, Debug, Eq, Hash, PartialEq)]
pub enum Tool {
    /// MuJoCo.
    Mujoco,
    /// Drake's `MultibodyPlant`, point contact.
    Drake,
    /// Gazebo: Classic with ODE, and what the new one reads of the same SDF.
    Gazebo,
    /// Open Dynamics Engine, by its own interface.
    Ode,
    /// Bullet and PyBullet.
    Bullet,
    /// PhysX 5, Isaac Sim and Isaac Lab.
    Physx,
    /// Rapier.
    Rapier,
    /// Project Chrono, smooth contacts (SMC).
    Chrono,
    /// Adams, the IMPACT function; also MotionSolve, RecurDyn and SolidWorks Motion.
    Adams,
    /// Simscape Multibody, Spatial Contact Force.
    Simscape,
}

impl Tool {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::Mujoco,
        Self::Drake,
        Self::Gazebo,
        Self::Ode,
        Self::Bullet,
        Self::Physx,
        Self::Rapier,
        Self::Chrono,
        Self::Adams,
        Self::Simscape,
    ];

    /// As it is written in files and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mujoco => "mujoco",
            Self::Drake => "drake",
            Self::Gazebo => "gazebo",
            Self::Ode => "ode",
            Self::Bullet => "bullet",
            Self::Physx => "physx",
            Self::Rapier => "rapier",
            Self::Chrono => "chrono",
            Self::Adams => "adams",
            Self::Simscape => "simscape",
        }
    }

    /// As its makers write it.
    pub fn title(self) -> &'static str {
        match self {
            Self::Mujoco => "MuJoCo",
            Self::Drake => "Drake",
            Self::Gazebo => "Gazebo",
            Self::Ode => "Open Dynamics Engine",
            Self::Bullet => "Bullet",
            Self::Physx => "PhysX and Isaac",
            Self::Rapier => "Rapier",
            Self::Chrono => "Project Chrono (SMC)",
            Self::Adams => "Adams (IMPACT)",
            Self::Simscape => "Simscape Multibody",
        }
    }

    /// Other names that [`Tool::from_name`] takes.
    pub fn aliases(self) -> &'static [&'static str] {
        match self {
            Self::Mujoco => &["mjcf"],
            Self::Drake => &["sap"],
            Self::Gazebo => &["sdf", "sdformat", "gz", "gazebo-classic", "ignition"],
            Self::Ode => &["open-dynamics-engine"],
            Self::Bullet => &["pybullet", "bullet3"],
            Self::Physx => &["isaac", "isaac-sim", "isaac-lab", "isaaclab"],
            Self::Rapier => &["rapier3d"],
            Self::Chrono => &["project-chrono", "pychrono", "smc"],
            Self::Adams => &["impact", "motionsolve", "recurdyn", "solidworks-motion"],
            Self::Simscape => &["simscape-multibody", "matlab", "simulink"],
        }
    }
}

impl std::fmt::Display for Tool {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl serde::Serialize for Tool {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}
