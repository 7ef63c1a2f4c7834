//! Kinds of findings: stable code, severity and scope of each.

use percuss_mechanism::Severity;

/// Poses for which a finding holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FindingScope {
    /// All poses of the model with the same contact.
    Model,
    /// All poses of a branch.
    Branch,
    /// One pose; determined by the joint positions alone.
    Positions,
    /// One pose; determined by its contact response, or by the way in which the pose was found.
    Pose,
    /// A report, not a single row.
    Report,
}

impl FindingScope {
    /// True if the finding holds for all poses of a branch.
    pub fn covers_branch(self) -> bool {
        match self {
            Self::Model | Self::Branch => true,
            Self::Positions | Self::Pose | Self::Report => false,
        }
    }
}

/// Declares the kinds with their codes, severities and scopes. The order of the kinds is the order of the findings in a report.
macro_rules! finding_kinds {
    ($($kind:ident = $code:literal, $severity:ident, $scope:ident;)*) => {
        /// Kind of a finding.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
        pub(crate) enum FindingKind {
            $($kind,)*
        }

        impl FindingKind {
            /// All kinds.
            #[cfg(test)]
            const ALL: &[Self] = &[$(Self::$kind,)*];

            /// Code, usual severity and scope.
            const fn properties(self) -> (&'static str, Severity, FindingScope) {
                match self {
                    $(Self::$kind => ($code, Severity::$severity, FindingScope::$scope),)*
                }
            }
        }
    };
}

finding_kinds! {
    AlwaysTouching = "always-touching", Warning, Report;
    BaseAtRest = "base-at-rest", Note, Report;
    BaseNotGiven = "base-not-given", Warning, Pose;
    BehindDeadCentre = "behind-dead-centre", Warning, Report;
    BushesRigid = "bushes-rigid", Note, Model;
    ContactGuessed = "contact-guessed", Warning, Report;
    CurveNotUsed = "curve-not-used", Note, Report;
    DefaultDistance = "default-distance", Note, Report;
    DrawnOpen = "drawn-open", Warning, Model;
    DriverOffZero = "driver-off-zero", Warning, Branch;
    DriversChosen = "drivers-chosen", Note, Branch;
    ExportsOwnLaw = "exports-own-law", Note, Report;
    ExtendingElement = "extending-element", Warning, Report;
    FarContactTravel = "far-contact-travel", Warning, Report;
    FarFromGuess = "far-from-guess", Warning, Pose;
    FarPoint = "far-point", Warning, Model;
    ForceBeyondData = "force-beyond-data", Warning, Report;
    GearsRigid = "gears-rigid", Note, Model;
    HoldPulls = "hold-pulls", Warning, Pose;
    HoldUndetermined = "hold-undetermined", Note, Pose;
    ImmovableMechanism = "immovable-mechanism", Note, Pose;
    ImmovableRobot = "immovable-robot", Warning, Report;
    ImplausibleContact = "implausible-contact", Warning, Report;
    IndefiniteMassMatrix = "indefinite-mass-matrix", Warning, Pose;
    InexactLoops = "inexact-loops", Warning, Model;
    JointSprings = "joint-springs", Note, Model;
    LawContradicted = "law-contradicted", Warning, Report;
    LawOfCurve = "law-of-curve", Note, Report;
    ManyTurns = "many-turns", Warning, Model;
    MassDrifts = "mass-drifts", Warning, Report;
    MasslessMotions = "massless-motions", Note, Pose;
    MasslessToRounding = "massless-to-rounding", Warning, Pose;
    NearlyImmovable = "nearly-immovable", Warning, Pose;
    NoAnswer = "no-answer", Warning, Pose;
    NoCompliance = "no-compliance", Warning, Report;
    NoDamper = "no-damper", Warning, Report;
    NoDriver = "no-driver", Warning, Report;
    NoGeometricStiffness = "no-geometric-stiffness", Note, Report;
    NotFinite = "not-finite", Warning, Pose;
    NotUnitQuaternion = "not-unit-quaternion", Warning, Pose;
    ObliqueStop = "oblique-stop", Note, Report;
    OffTarget = "off-target", Warning, Branch;
    OpenComponents = "open-components", Warning, Report;
    OpenGap = "open-gap", Warning, Positions;
    OpenLoops = "open-loops", Warning, Pose;
    OtherAssembly = "other-assembly", Warning, Pose;
    OutsideLimits = "outside-limits", Warning, Positions;
    PartsNotUsed = "parts-not-used", Note, Report;
    PenetrationUnreachable = "penetration-unreachable", Warning, Report;
    PointConverted = "point-converted", Note, Pose;
    PointMassBase = "point-mass-base", Warning, Model;
    PoseOfAnotherFile = "pose-of-another-file", Warning, Report;
    RackMoved = "rack-moved", Warning, Report;
    RestitutionAboveOne = "restitution-above-one", Warning, Report;
    RestitutionNotReached = "restitution-not-reached", Warning, Report;
    ReversedAxis = "reversed-axis", Note, Model;
    RigidLoops = "rigid-loops", Warning, Model;
    RowsFollowed = "rows-followed", Note, Report;
    RowsNotTried = "rows-not-tried", Note, Report;
    RowsUnanswered = "rows-unanswered", Warning, Report;
    RowsWithoutSpeed = "rows-without-speed", Warning, Report;
    ShapeNotDrawn = "shape-not-drawn", Note, Report;
    SingularPose = "singular-pose", Warning, Pose;
    SmallRows = "small-rows", Warning, Report;
    SpringsAct = "springs-act", Warning, Report;
    StandardTooFast = "standard-too-fast", Warning, Report;
    StopNotReached = "stop-not-reached", Warning, Report;
    StopPassed = "stop-passed", Warning, Pose;
    UncertainMass = "uncertain-mass", Warning, Pose;
    UnclearRank = "unclear-rank", Warning, Model;
    UnclearRankHere = "unclear-rank-here", Warning, Pose;
    UndeterminedMotion = "undetermined-motion", Note, Pose;
    UnitOfContacts = "unit-of-contacts", Warning, Report;
    UnitsAssumed = "units-assumed", Warning, Report;
    UnknownError = "unknown-error", Warning, Pose;
    UnusedGuess = "unused-guess", Warning, Pose;
    WeaklyConstrained = "weakly-constrained", Warning, Model;
    WeightNotGiven = "weight-not-given", Warning, Report;
    WithoutFriction = "without-friction", Warning, Report;
    WrongWayStop = "wrong-way-stop", Warning, Report;
}

impl FindingKind {
    /// Notes about elastic parts that are rigid in the result.
    pub const ELASTIC: [Self; 2] = [Self::BushesRigid, Self::GearsRigid];

    /// Stable short name.
    pub const fn code(self) -> &'static str {
        self.properties().0
    }

    /// Usual severity of a finding of this kind.
    pub const fn severity(self) -> Severity {
        self.properties().1
    }

    /// Poses for which a finding of this kind holds.
    pub const fn scope(self) -> FindingScope {
        self.properties().2
    }
}

#[cfg(test)]
mod tests {
    use super::FindingKind;

    /// Reports list findings in alphabetic order of their codes, and no code occurs twice.
    #[test]
    fn codes_ascend() {
        assert!(FindingKind::ALL.is_sorted_by(|a, b| a < b && a.code() < b.code()));
    }
}
