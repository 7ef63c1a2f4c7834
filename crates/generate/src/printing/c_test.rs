//! Self-test of the C code: a program that compares the functions with reference values of percuss.

use super::expression_text::{literal, wrapped_list};
use crate::function::Functions;
use crate::request::Request;
use std::fmt::Write;

/// Text of the self-test.
pub(super) fn test(request: &Request, functions: &Functions) -> String {
    let (n, upper) = (request.name.as_str(), request.name.to_uppercase());
    let references = functions.references();
    let count = references.len();
    let inputs = functions.tree.inputs.max(1);
    let mut out = format!(
        "/* Self-test, made by percuss: compares the functions with values that percuss computed. Returns 0 if all agree. */\n#include \
         \"{n}.h\"\n\n#include <math.h>\n#include <stdio.h>\n#include <string.h>\n\nstatic const double \
         reference_q[{count}][{inputs}] = {{\n"
    );
    for reference in &references {
        let values: Vec<String> = reference.inputs.iter().map(|x| literal(*x)).collect();
        let list = if values.is_empty() { "0.0".to_owned() } else { wrapped_list(&values, 5) };
        let _ = writeln!(out, "    {{{list}}},");
    }
    let masses: Vec<String> = references.iter().map(|r| literal(r.mass)).collect();
    let tolerances: Vec<String> = references.iter().map(|r| literal(r.tolerance)).collect();
    let _ = write!(
        out,
        "}};\nstatic const double reference_mass[{count}] = {{{}}};\n/* Relative tolerances: rounding, and the error that \
         percuss states. */\nstatic const double tolerance[{count}] = {{{}}};\n\n",
        wrapped_list(&masses, 4),
        wrapped_list(&tolerances, 4)
    );
    let _ = write!(
        out,
        "static int failed;\n\nstatic void check(const char *what, int k, double found, double expected, double \
         tolerance_of)\n{{\n    if (!(fabs(found - expected) <= tolerance_of)) {{\n        printf(\"%s, configuration %d: \
         %.17g instead of %.17g\\n\", what, k, found, expected);\n        failed = 1;\n    }}\n}}\n\nint main(void)\n{{\n    int \
         k;\n    for (k = 0; k < {count}; ++k) {{\n        const double *q = reference_q[k];\n        const double expected = \
         reference_mass[k];\n        const double least = tolerance[k]*fabs(expected);\n        double mass = -1.0;\n        int \
         status = {n}_mass(q, &mass);\n        check(\"status\", k, status, {upper}_OK, 0.0);\n        check(\"mass\", k, mass, \
         expected, least);\n"
    );
    let has = request.additions;
    if has.velocity && !functions.velocities.is_empty() {
        let _ = write!(
            out,
            "        {{\n            double v[{upper}_VELOCITIES];\n            status = {n}_velocity(q, &mass, v);\n            \
             check(\"status of velocity\", k, status, {upper}_OK, 0.0);\n            check(\"mass of velocity\", k, mass, \
             expected, least);\n        }}\n"
        );
    }
    if has.gradient && !functions.gradient.is_empty() {
        let _ = write!(
            out,
            "        {{\n            double derivatives[{upper}_DERIVATIVES];\n            status = {n}_gradient(q, &mass, \
             derivatives);\n            check(\"status of gradient\", k, status, {upper}_OK, 0.0);\n            check(\"mass of \
             gradient\", k, mass, expected, least);\n        }}\n"
        );
    }
    if has.mobility {
        let _ = write!(
            out,
            "        {{\n            double mobility[36];\n            status = {n}_mobility(q, mobility);\n            \
             check(\"status of mobility\", k, status, {upper}_OK, 0.0);\n        }}\n"
        );
    }
    if has.batch {
        let _ = write!(
            out,
            "        {{\n            double columns[3*{inputs}], masses[3];\n            int i;\n            for (i = 0; i < \
             3*{inputs}; ++i) {{\n                columns[i] = q[i/3];\n            }}\n            check(\"count of batch\", k, \
             (double){n}_batch(3, columns, 3, masses), 0.0, 0.0);\n            check(\"mass of batch\", k, masses[2], expected, \
             least);\n        }}\n"
        );
    }
    if has.close {
        let _ = write!(
            out,
            "        {{\n            double closed[{inputs}], residual;\n            memcpy(closed, q, sizeof closed);\n            \
             status = {n}_close(closed, &residual);\n            check(\"status of close\", k, status, {upper}_OK, 0.0);\n            \
             status = {n}_mass(closed, &mass);\n            check(\"mass of closed positions\", k, mass, expected, \
             1e-7*fabs(expected) + least);\n        }}\n"
        );
    }
    let _ = write!(
        out,
        "    }}\n    printf(\"%s\\n\", failed ? \"the functions disagree with percuss\" : \"{count} configurations agree with \
         percuss\");\n    return failed;\n}}\n"
    );
    if !has.close {
        out = out.replace("#include <string.h>\n", "");
    }
    out
}
