//! Rust code without the standard library, with its tests.

use super::description::{
    GeneratedFile, LARGEST_ANGLE, NEWTON_STEPS, conditions, coordinate_name, header_lines, output_name,
    plain, position_rows, quaternion_joints, used_inputs,
};
use super::expression_text::{Names, Printer, literal, wrapped_list};
use super::rust_text::{SINE_COSINE, SQUARE_ROOT};
use crate::expression::graph::Expr;
use crate::expression::statements::Statements;
use crate::function::{Functions, NamedOutput};
use crate::request::Request;
use percuss_mechanism::JointKind;
use std::fmt::Write;

/// File of the Rust code.
pub(super) fn files(request: &Request, functions: &Functions) -> Vec<GeneratedFile> {
    let rust = RustSource { request, functions };
    vec![GeneratedFile { name: format!("{}.rs", request.name), text: rust.text() }]
}

struct RustSource<'a> {
    request: &'a Request,
    functions: &'a Functions,
}

impl RustSource<'_> {
    fn text(&self) -> String {
        let has = self.request.additions;
        let functions = self.functions;
        let mut body = self.mass_function(
            "mass",
            "f64",
            &functions.mass_statements(),
            "m",
            "Effective mass m, kg.",
            &[],
        );
        if has.velocity {
            let outputs = &functions.velocities;
            let rows: Vec<String> = outputs.iter().map(|o| output_name(self.request, o)).collect();
            body += &self.outputs_function(
                "velocity",
                outputs,
                &rows,
                "m",
                "Effective mass, and velocities of the joints at unit closing speed, of least kinetic energy",
            );
        }
        if has.gradient {
            let outputs = &functions.gradient;
            let unit = |o: &NamedOutput| if o.turns { "kg/rad" } else { "kg/m" };
            let rows: Vec<String> = outputs
                .iter()
                .map(|o| format!("{}, {}", coordinate_name(self.request, o), unit(o)))
                .collect();
            body += &self.outputs_function(
                "gradient",
                outputs,
                &rows,
                "-m*m",
                "Effective mass, and its derivatives at unit rate of each independent joint",
            );
        }
        if has.mobility {
            body += &self.mobility_function();
        }
        if has.batch {
            body += &self.batch_function();
        }
        if has.close {
            body += &self.close_function();
        }
        let mut out = String::new();
        for line in header_lines(self.request) {
            out += format!("//! {line}").trim_end();
            out.push('\n');
        }
        out += "//!\n//! Positions q (SI units):\n//!\n//! ```text\n";
        for row in position_rows(self.request, functions) {
            let _ = writeln!(out, "//! {row}");
        }
        out += "//! ```\n";
        if functions.closure.is_some() {
            let _ = write!(
                out,
                "//!\n//! The positions have to close the loops, within {} m (angles times {} m).\n",
                literal(functions.closure_tolerance),
                literal(self.request.scale())
            );
        }
        out +=
            "//!\n//! The code needs `core` only: declare `#![no_std]` in the crate and `mod` this file.\n\n";
        out += "#![allow(clippy::all, clippy::pedantic, unused_parens)]\n#![allow(unused_variables, dead_code)]\n\n";
        let _ = write!(
            out,
            "/// Number of positions.\npub const POSITIONS: usize = {};\n\n/// SHA-256 of the model file.\npub const MODEL: &str \
             = \"{}\";\n\n",
            functions.tree.inputs, self.request.model_hash
        );
        let _ = write!(
            out,
            "/// Reason why a configuration has no result.\n#[derive(Clone, Copy, Debug, PartialEq, Eq)]\npub enum Refusal {{\n    \
             /// No motion closes the gap: m is infinite.\n    Immovable,\n    /// An angle is beyond {} rad, or a number is not \
             finite.\n    Range,\n    /// The positions do not close the loops.\n    Open,\n    /// The loops are at a dead centre \
             of the independent joints, or have another rank.\n    Singular,\n    /// The line that defines the normal is too \
             short.\n    Line,\n}}\n\n",
            literal(LARGEST_ANGLE)
        );
        if body.contains("sine_cosine(") {
            out += SINE_COSINE;
            out.push('\n');
        }
        if body.contains("square_root(") {
            out += SQUARE_ROOT;
            out.push('\n');
        }
        out += &body;
        out += &self.tests();
        out
    }

    /// Passes a printer to `print`; inputs, sines and cosines are array elements.
    fn with_printer<R>(&self, statements: &Statements, print: impl FnOnce(&Printer) -> R) -> R {
        let names = Names {
            input: &|i| format!("q[{i}]"),
            sine: &|k| format!("s[{k}]"),
            cosine: &|k| format!("c[{k}]"),
            root: &|text| format!("square_root({text})"),
        };
        print(&Printer { graph: &self.functions.graph, statements, names })
    }

    /// Declarations of the angles, their sines and cosines, the sum `range` of the squared angles, and the variables.
    fn preparation(&self, printer: &Printer, indent: &str) -> String {
        let statements = printer.statements;
        let n = statements.angles.len();
        let angles: Vec<String> = statements.angles.iter().map(|a| printer.angle(*a)).collect();
        let mut out = format!("{indent}let angle: [f64; {n}] = [{}];\n", wrapped_list(&angles, 8));
        let _ = write!(
            out,
            "{indent}let (mut s, mut c, mut range) = ([0.0; {n}], [0.0; {n}], 0.0);\n{indent}for i in 0..{n} {{\n"
        );
        if n > 0 {
            let _ = writeln!(out, "{indent}    (s[i], c[i]) = sine_cosine(angle[i]);");
        }
        let _ = write!(out, "{indent}    range += angle[i]*angle[i];\n{indent}}}\n");
        for &variable in &statements.variables {
            let name = statements.names[variable.index()].unwrap_or(0);
            let _ = writeln!(out, "{indent}let x{name}: f64 = {};", printer.definition(variable));
        }
        out
    }

    /// Checks of the range and the loops, and of the line of the normal if `with_line`; a failed check returns a refusal.
    fn checks(&self, printer: &Printer, indent: &str, with_line: bool) -> String {
        let check = |(condition, status): (String, &str)| {
            format!("{indent}if !({condition}) {{\n{indent}    return Err(Refusal::{status});\n{indent}}}\n")
        };
        conditions(self.functions, printer, with_line).into_iter().map(check).collect()
    }

    /// Function that returns `Result<result, Refusal>`; its last expression is `Ok(value)`, where `m` is m̄. `about` and
    /// the `rows`, one per output, are its documentation.
    fn mass_function(
        &self,
        name: &str,
        result: &str,
        statements: &Statements,
        value: &str,
        about: &str,
        rows: &[String],
    ) -> String {
        self.with_printer(statements, |printer| {
            let mut out = format!("/// {about}\n");
            if !rows.is_empty() {
                out += "///\n/// ```text\n";
                for (k, row) in rows.iter().enumerate() {
                    let _ = writeln!(out, "/// [{k}]  {row}");
                }
                out += "/// ```\n";
            }
            let _ = writeln!(out, "pub fn {name}(q: &[f64; POSITIONS]) -> Result<{result}, Refusal> {{");
            out += &self.preparation(printer, "    ");
            let _ = writeln!(out, "    let response: f64 = {};", printer.result(self.functions.response));
            out += &self.checks(printer, "    ", true);
            let _ = write!(
                out,
                "    if !(response < f64::INFINITY) {{\n        return Err(Refusal::Range);\n    }}\n    if !(response > {}) {{\n        \
                 return Err(Refusal::Immovable);\n    }}\n    let m = 1.0/response;\n    Ok({})\n}}\n\n",
                literal(self.functions.immovable),
                value
            );
            out
        })
    }

    /// Function of m̄ and an array of outputs, each times `factor`.
    fn outputs_function(
        &self,
        name: &str,
        outputs: &[NamedOutput],
        rows: &[String],
        factor: &str,
        about: &str,
    ) -> String {
        let statements = self.functions.statements_with(outputs.iter());
        let values: Vec<String> = self.with_printer(&statements, |printer| {
            outputs.iter().map(|o| format!("{factor}*({})", printer.result(o.value))).collect()
        });
        let value = format!("(m, [{}])", values.join(", "));
        let result = format!("(f64, [f64; {}])", outputs.len());
        self.mass_function(name, &result, &statements, &value, &format!("{about}."), rows)
    }

    /// Function that returns the 6×6 matrix J M⁻¹ Jᵀ of the contact link.
    fn mobility_function(&self) -> String {
        let mut results: Vec<Expr> =
            [self.functions.closure, self.functions.choice].into_iter().flatten().collect();
        results.extend(&self.functions.mobility);
        let statements = Statements::new(&self.functions.graph, &results);
        self.with_printer(&statements, |printer| {
            let mut out = String::from(
                "/// Matrix J M^-1 J^T of the link at the contact point, symmetric, in the axes of the link: moments first,\n/// \
                 then forces. 1/m = n^T F n of the lower right block; 0 along an immovable direction.\npub fn mobility(q: &[f64; \
                 POSITIONS]) -> Result<[[f64; 6]; 6], Refusal> {\n",
            );
            out += &self.preparation(printer, "    ");
            out += &self.checks(printer, "    ", false);
            let entries: Vec<String> = self.functions.mobility.iter().map(|e| printer.result(*e)).collect();
            let rows: Vec<String> = entries.chunks(6).map(|row| format!("        [{}]", row.join(", "))).collect();
            let _ = write!(
                out,
                "    let matrix = [\n{},\n    ];\n    let mut sum = 0.0;\n    for row in &matrix {{\n        for x in row {{\n            \
                 sum += x;\n        }}\n    }}\n    if sum - sum == 0.0 {{ Ok(matrix) }} else {{ Err(Refusal::Range) }}\n}}\n\n",
                rows.join(",\n")
            );
            out
        })
    }

    /// Function for many configurations, written so that the compiler vectorises its loop.
    fn batch_function(&self) -> String {
        let statements = self.functions.mass_statements();
        let used = used_inputs(self.functions, &statements);
        let names = Names {
            input: &|i| format!("a{i}"),
            sine: &|k| format!("s{k}"),
            cosine: &|k| format!("c{k}"),
            root: &|text| format!("square_root({text})"),
        };
        let printer = Printer { graph: &self.functions.graph, statements: &statements, names };
        let mut out = String::from(
            "/// Effective masses of many configurations. Position i of configuration k is q[i*n + k], n = mass.len(). A \
             configuration\n/// without a result gives NAN, or INFINITY if it is immovable.\n///\n/// # Panics\n/// If q is shorter \
             than POSITIONS*n.\npub fn batch(q: &[f64], mass: &mut [f64]) {\n    let n = mass.len();\n",
        );
        for &i in &used {
            let _ = writeln!(out, "    let q{i} = &q[{i}*n..][..n];");
        }
        out += "    for k in 0..n {\n";
        for &i in &used {
            let _ = writeln!(out, "        let a{i} = q{i}[k];");
        }
        let mut range = Vec::new();
        for (k, angle) in statements.angles.iter().enumerate() {
            let text = printer.angle(*angle);
            let _ = write!(
                out,
                "        let b{k}: f64 = {text};\n        let (s{k}, c{k}) = sine_cosine(b{k});\n"
            );
            range.push(format!("b{k}*b{k}"));
        }
        for &variable in &statements.variables {
            let name = statements.names[variable.index()].unwrap_or(0);
            let _ = writeln!(out, "        let x{name}: f64 = {};", printer.definition(variable));
        }
        let _ = writeln!(out, "        let response: f64 = {};", printer.result(self.functions.response));
        let mut conditions = vec!["response < f64::INFINITY".to_owned()];
        if !range.is_empty() {
            conditions.push(format!("{} <= {}", range.join(" + "), literal(LARGEST_ANGLE * LARGEST_ANGLE)));
        }
        let limits = [self.functions.line, self.functions.closure, self.functions.choice];
        conditions.extend(limits.into_iter().flatten().map(|e| format!("{} <= 1.0", printer.result(e))));
        let _ = writeln!(
            out,
            "        let mut m = if response > {} {{ 1.0/response }} else {{ f64::INFINITY }};",
            literal(self.functions.immovable)
        );
        for condition in conditions {
            let _ = writeln!(out, "        m = if {condition} {{ m }} else {{ f64::NAN }};");
        }
        out += "        mass[k] = m;\n    }\n}\n\n";
        out
    }

    /// Function that closes the loops by Newton steps on the dependent positions.
    fn close_function(&self) -> String {
        let functions = self.functions;
        let mut results: Vec<Expr> = [functions.closure, functions.choice].into_iter().flatten().collect();
        results.extend(functions.steps.iter().map(|step| step.value));
        let statements = Statements::new(&functions.graph, &results);
        let count = functions.steps.len();
        let scale = self.request.scale();
        let mechanism = self.request.system.mechanism();
        let drivers: Vec<String> = functions
            .drivers
            .iter()
            .map(|id| format!("\"{}\"", plain(mechanism.joint(*id).name())))
            .collect();
        self.with_printer(&statements, |printer| {
            let text = |e: Option<Expr>| e.map_or_else(|| "0.0".to_owned(), |e| printer.result(e));
            let mut out = format!(
                "/// Closes the loops by at most {NEWTON_STEPS} Newton steps: q holds the positions of the driving joints \
                 ({})\n/// and previous values of the others, which are replaced. Returns the root of the sum of squares of the \
                 residuals, m.\npub fn close(q: &mut [f64; POSITIONS]) -> Result<f64, Refusal> {{\n    let mut is_last = false;\n    for \
                 _ in 0..={NEWTON_STEPS} {{\n",
                drivers.join(", ")
            );
            out += &self.preparation(printer, "        ");
            let steps: Vec<String> = functions.steps.iter().map(|s| printer.result(s.value)).collect();
            let lengths: Vec<String> = functions.steps.iter().map(|s| literal(s.length(scale))).collect();
            let _ = write!(
                out,
                "        let closure: f64 = {};\n        let choice: f64 = {};\n        if !(range <= {}) {{\n            return \
                 Err(Refusal::Range);\n        }}\n        if is_last {{\n            if !(choice <= 1.0) {{\n                return \
                 Err(Refusal::Singular);\n            }}\n            if !(closure <= 1.0) {{\n                return \
                 Err(Refusal::Open);\n            }}\n            return Ok({}*square_root(closure));\n        }}\n        let mut step: \
                 [f64; {count}] = [{}];\n        let length: [f64; {count}] = [{}];\n        let mut square = 0.0;\n        for k in \
                 0..{count} {{\n            square += step[k]*step[k]*length[k]*length[k];\n        }}\n        if !(square < \
                 f64::INFINITY) {{\n            return Err(Refusal::Singular);\n        }}\n        if square > {largest} {{\n            // \
                 Long steps are shortened.\n            let factor = square_root({largest}/square);\n            for x in &mut step \
                 {{\n                *x *= factor;\n            }}\n        }}\n        is_last = square < {least};\n",
                text(functions.closure),
                text(functions.choice),
                literal(LARGEST_ANGLE * LARGEST_ANGLE),
                literal(functions.closure_tolerance),
                wrapped_list(&steps, 12),
                wrapped_list(&lengths, 12),
                largest = literal((0.5 * scale).powi(2)),
                least = literal((1e-9 * scale).powi(2)),
            );
            out += &self.position_updates();
            out += "    }\n    Err(Refusal::Open)\n}\n\n";
            out
        })
    }

    /// Statements that add the Newton step to the positions.
    fn position_updates(&self) -> String {
        let mut out = String::new();
        let steps = &self.functions.steps;
        for (k, step) in steps.iter().enumerate() {
            if !matches!(step.kind, JointKind::Spherical | JointKind::Floating) {
                let _ = writeln!(out, "        q[{}] += step[{k}];", step.first + step.component);
            }
        }
        for (first, kind) in quaternion_joints(steps) {
            let of = |component: usize| {
                let at = steps.iter().position(|s| s.first == first && s.component == component);
                at.map_or_else(|| "0.0".to_owned(), |k| format!("step[{k}]"))
            };
            let shift = if kind == JointKind::Floating { 3 } else { 0 };
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| format!("q[{}]", first + shift + k));
            let _ = write!(
                out,
                "        {{\n            let (w, x, y, z) = ({a}, {b}, {c}, {d});\n            let (u0, u1, u2) = (0.5*{}, 0.5*{}, \
                 0.5*{});\n",
                of(0),
                of(1),
                of(2)
            );
            if kind == JointKind::Floating {
                let _ = write!(
                    out,
                    "            let (v0, v1, v2) = ({}, {}, {});\n            q[{first}] += (1.0 - 2.0*(y*y + z*z))*v0 + 2.0*(x*y \
                     - w*z)*v1 + 2.0*(x*z + w*y)*v2;\n            q[{}] += 2.0*(x*y + w*z)*v0 + (1.0 - 2.0*(x*x + z*z))*v1 + 2.0*(y*z \
                     - w*x)*v2;\n            q[{}] += 2.0*(x*z - w*y)*v0 + 2.0*(y*z + w*x)*v1 + (1.0 - 2.0*(x*x + y*y))*v2;\n",
                    of(3),
                    of(4),
                    of(5),
                    first + 1,
                    first + 2
                );
            }
            let _ = write!(
                out,
                "            let e0 = w - x*u0 - y*u1 - z*u2;\n            let e1 = x + w*u0 + y*u2 - z*u1;\n            let e2 = y + \
                 w*u1 - x*u2 + z*u0;\n            let e3 = z + w*u2 + x*u1 - y*u0;\n            let norm = 1.0/square_root(e0*e0 + e1*e1 \
                 + e2*e2 + e3*e3);\n            {a} = e0*norm;\n            {b} = e1*norm;\n            {c} = e2*norm;\n            {d} = \
                 e3*norm;\n        }}\n"
            );
        }
        out
    }

    /// Tests against reference values of percuss.
    fn tests(&self) -> String {
        let references = self.functions.references();
        let has = self.request.additions;
        let mut out = String::from(
            "#[cfg(test)]\nmod tests {\n    use super::*;\n\n    const REFERENCES: &[([f64; POSITIONS], f64, f64)] = &[\n",
        );
        for reference in &references {
            let values: Vec<String> = reference.inputs.iter().map(|x| literal(*x)).collect();
            let _ = writeln!(
                out,
                "        ([{}], {}, {}),",
                wrapped_list(&values, 10),
                literal(reference.mass),
                literal(reference.tolerance)
            );
        }
        out += "    ];\n\n    #[test]\n    fn functions_agree_with_percuss() {\n        for &(q, expected, tolerance) in REFERENCES {\n            let agrees = |m: f64| (m - expected).abs() <= tolerance*expected.abs();\n            assert!(agrees(mass(&q).unwrap()));\n";
        if has.velocity {
            out += "            assert!(agrees(velocity(&q).unwrap().0));\n";
        }
        if has.gradient {
            out += "            assert!(agrees(gradient(&q).unwrap().0));\n";
        }
        if has.mobility {
            out += "            mobility(&q).unwrap();\n";
        }
        if has.batch {
            out += "            let mut columns = [0.0; 3*POSITIONS];\n            for i in 0..3*POSITIONS {\n                columns[i] = q[i/3];\n            }\n            let mut masses = [0.0; 3];\n            batch(&columns, &mut masses);\n            assert!(masses.iter().all(|m| agrees(*m)));\n";
        }
        if has.close {
            out += "            let mut closed = q;\n            close(&mut closed).unwrap();\n            let m = mass(&closed).unwrap();\n            assert!((m - expected).abs() <= (1e-7 + tolerance)*expected.abs());\n";
        }
        out += "        }\n    }\n}\n";
        out
    }
}
