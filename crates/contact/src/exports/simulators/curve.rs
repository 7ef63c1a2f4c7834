//! Force curve with Hunt–Crossley damping as code for tools that take a force of their own.

use crate::exports::{Export, Tool};
use crate::{ForceCurve, limits};
use std::fmt::Write;

/// Adds the force F = max(0, F_s(x)(1 + d ẋ)) of a curve F_s to the snippets of a tool that has splines or forces in code. `dissipation`: d, s/m.
pub(super) fn add_snippet(export: &mut Export, curve: &ForceCurve, dissipation: f64) {
    let points = points(curve);
    let list = |of: fn(&(f64, f64)) -> f64| {
        points.iter().map(|point| format!("{:?}", of(point))).collect::<Vec<_>>().join(", ")
    };
    let (deflections, forces) = (list(|point| point.0), list(|point| point.1));
    let python = format!("DEFLECTIONS = [{deflections}]  # m\nFORCES = [{forces}]  # N\n");
    let law = format!("max(0.0, np.interp(x, DEFLECTIONS, FORCES) * (1 + {dissipation:?} * speed))");
    let text = if export.tool == Tool::EXUDYN {
        format!(
            "import numpy as np\nfrom exudyn.itemInterface import ObjectConnectorSpringDamper\n\n{python}\n\n\
             def force(mbs, t, item, stretch, rate, stiffness, damping, offset):\n    \
             \"\"\"Force of the stop, N; stretch and rate of the distance of both markers, m and m/s.\"\"\"\n    \
             x, speed = -stretch, -rate\n    return -{law} if x > 0 else 0.0\n\n\n\
             def stop(markers, length):\n    \
             \"\"\"markers of a point of each body; length: their distance at the first touch, m.\"\"\"\n    \
             return ObjectConnectorSpringDamper(\n        markerNumbers=markers, referenceLength=length, \
             springForceUserFunction=force\n    )\n"
        )
    } else if export.tool == Tool::DRAKE {
        format!(
            "import numpy as np\nfrom pydrake.multibody.math import SpatialForce\n\
             from pydrake.multibody.plant import ExternallyAppliedSpatialForce\n\
             from pydrake.common.value import Value\nfrom pydrake.systems.framework import LeafSystem\n\n{python}\n\n\
             class Stop(LeafSystem):\n    \"\"\"Force on a body along a fixed normal (world axes, away from the obstacle) at a point of the \
             body.\n\n    \
             gap: distance of the point from the obstacle at the pose with the point at the origin of the world, m.\"\"\"\n\n    \
             def __init__(self, plant, body, point, normal, gap):\n        super().__init__()\n        \
             self.body, self.point, self.normal, self.gap = body, np.array(point), np.array(normal), gap\n        \
             self.poses = self.DeclareAbstractInputPort(\"poses\", Value(plant.get_body_poses_output_port().Allocate().get_value()))\n        \
             self.rates = self.DeclareAbstractInputPort(\"rates\", Value(plant.get_body_spatial_velocities_output_port().Allocate().get_value()))\n        \
             self.DeclareAbstractOutputPort(\"force\", lambda: Value([ExternallyAppliedSpatialForce()]), self.force)\n\n    \
             def force(self, context, output):\n        at = self.body.index()\n        pose = self.poses.Eval(context)[at]\n        \
             rate = self.rates.Eval(context)[at]\n        arm = pose.rotation().multiply(self.point)\n        \
             x = -(self.gap + self.normal @ (pose.translation() + arm))\n        \
             speed = -self.normal @ (rate.translational() + np.cross(rate.rotational(), arm))\n        \
             magnitude = {law} if x > 0 else 0.0\n        applied = ExternallyAppliedSpatialForce()\n        \
             applied.body_index, applied.p_BoBq_B = at, self.point\n        \
             applied.F_Bq_W = SpatialForce(np.zeros(3), magnitude * self.normal)\n        output.set_value([applied])\n"
        )
    } else if export.tool == Tool::CHRONO {
        format!(
            "#include <algorithm>\n#include \"chrono/physics/ChLinkTSDA.h\"\n\n// For link->RegisterForceFunctor(std::make_shared<Stop>()); the rest length is the \
             length at the first touch.\nclass Stop : public chrono::ChLinkTSDA::ForceFunctor {{\n  public:\n    \
             double evaluate(double, double rest, double length, double rate, const chrono::ChLinkTSDA&) override {{\n        \
             static const double x[] = {{{deflections}}};  // m\n        static const double f[] = {{{forces}}};  // N\n        \
             const double depth = rest - length;\n        if (depth <= 0)\n            return 0;\n        int i = 1;\n        \
             while (i + 1 < {count} && depth > x[i])\n            ++i;\n        \
             const double spring = f[i - 1] + (depth - x[i - 1]) * (f[i] - f[i - 1]) / (x[i] - x[i - 1]);\n        \
             return std::max(0.0, spring * (1 - {dissipation:?} * rate));\n    }}\n}};\n",
            count = points.len()
        )
    } else if export.tool == Tool::ADAMS {
        let mut text = "! 0.1 m: distance of the markers at the first touch. AKISPL is smooth where the curve has corners.\n".to_owned();
        let column = |of: fn(&(f64, f64)) -> f64| {
            points.iter().map(|point| format!("{:?}", of(point))).collect::<Vec<_>>().join("\n, ")
        };
        let (xs, ys) = (column(|point| point.0), column(|point| point.1));
        let _ = write!(
            text,
            "SPLINE/1\n, X = {xs}\n, Y = {ys}\nSFORCE/1, I = 11, J = 21, TRANSLATION\n\
             , FUNCTION = IF(0.1-DM(11,21): 0, 0, MAX(0,\n\
             , AKISPL(0.1-DM(11,21), 0, 1)*(1-{dissipation:?}*VR(11,21))))\n"
        );
        text
    } else if export.tool == Tool::SIMSCAPE {
        format!(
            "component stop\n% File stop.ssc, block Simscape Component. x: penetration, the negative separation distance; v: its rate; f: \
             normal force,\n% for the input of Spatial Contact Force (Normal Force > Method: Provided by Input) or of a joint.\n  inputs\n    \
             x = {{0, 'm'}};   % x\n    v = {{0, 'm/s'}}; % v\n  end\n  outputs\n    f = {{0, 'N'}};   % f\n  end\n  parameters\n    \
             deflections = {{[{deflections}], 'm'}};\n    forces = {{[{forces}], 'N'}};\n    \
             dissipation = {{{dissipation:?}, 's/m'}};\n  end\n  equations\n    if x > 0 && dissipation*v > -1\n      \
             f == tablelookup(deflections, forces, x, interpolation=linear, extrapolation=linear)*(1 + dissipation*v);\n    \
             else\n      f == {{0, 'N'}};\n    end\n  end\nend\n"
        )
    } else {
        return;
    };
    let language = match export.tool {
        tool if tool == Tool::ADAMS => "adams",
        tool if tool == Tool::CHRONO => "cpp",
        tool if tool == Tool::SIMSCAPE => "matlab",
        _ => "python",
    };
    export.add_snippet("force curve", language, text);
    export.add_assumption(format!(
        "The snippet \"force curve\" has the curve itself, with the dissipation {dissipation:?} s/m: restitution, peak force and penetration are \
         those of the report.{}",
        match export.tool {
            tool if tool == Tool::ADAMS => " Akima's spline deviates from the lines between the points. Not run in Adams.",
            tool if tool == Tool::CHRONO => " Not run in Chrono.",
            tool if tool == Tool::SIMSCAPE => " Not run in Simscape.",
            _ => "",
        }
    ));
}

/// Points of a curve; powers by equal steps. The last slope continues over the length of the curve.
fn points(curve: &ForceCurve) -> Vec<(f64, f64)> {
    let (end, force) = curve.end();
    let mut points: Vec<(f64, f64)> = if curve.terms().is_empty() {
        curve.deflections().iter().copied().zip(curve.forces().iter().copied()).collect()
    } else {
        let steps = limits::POINTS_OF_POWERS;
        (0..=steps).map(|i| end * f64::from(i) / f64::from(steps)).map(|x| (x, curve.at(x).0)).collect()
    };
    points.push((2.0 * end, force + end * curve.at(2.0 * end).1));
    points
}
