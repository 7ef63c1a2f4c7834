//! C99 code: header, source, self-test. The code is valid C++ too.

use super::c_test;
use super::c_text::{NO_FAST_MATH, SINE_COSINE};
use super::description::{
    GeneratedFile, LARGEST_ANGLE, NEWTON_STEPS, conditions, coordinate_name, header_lines, output_name,
    plain, position_rows, quaternion_joints, used_inputs,
};
use super::expression_text::{Names, Printer, literal, wrapped_list};
use crate::expression::graph::Expr;
use crate::expression::statements::Statements;
use crate::function::{Functions, NamedOutput};
use crate::request::Request;
use percuss_mechanism::JointKind;
use std::fmt::Write;

/// Configurations of a batch whose checks are kept at once.
const BLOCK: usize = 64;

/// Files of the C code.
pub(super) fn files(request: &Request, functions: &Functions) -> Vec<GeneratedFile> {
    let c = CSource { request, functions, name: &request.name };
    let file = |ending: &str, text: String| GeneratedFile { name: format!("{}{ending}", request.name), text };
    vec![file(".h", c.header()), file(".c", c.source()), file("_test.c", c_test::test(request, functions))]
}

struct CSource<'a> {
    request: &'a Request,
    functions: &'a Functions,
    name: &'a str,
}

impl CSource<'_> {
    fn has(&self) -> &crate::request::Additions {
        &self.request.additions
    }

    /// Comment lines of a list of outputs.
    fn output_rows(&self, array: &str, outputs: &[NamedOutput], unit: bool) -> String {
        let row = |(k, output): (usize, &NamedOutput)| {
            let name = if unit {
                output_name(self.request, output)
            } else {
                let unit = if output.turns { "kg/rad" } else { "kg/m" };
                format!("{}, {unit}", coordinate_name(self.request, output))
            };
            format!("     {array}[{k}]  {name}\n")
        };
        outputs.iter().enumerate().map(row).collect()
    }

    fn header(&self) -> String {
        let (n, upper) = (self.name, self.name.to_uppercase());
        let mut out = String::from("/* ");
        for (k, line) in header_lines(self.request).iter().enumerate() {
            if k > 0 {
                out += if line.is_empty() { "\n" } else { "\n   " };
            }
            out += line;
        }
        let _ = write!(out, "\n\n   Positions q (SI units):\n");
        for row in position_rows(self.request, self.functions) {
            let _ = writeln!(out, "     {row}");
        }
        if self.functions.closure.is_some() {
            let _ = write!(
                out,
                "\n   The positions have to close the loops, within {} m (angles times {} m).\n",
                literal(self.functions.closure_tolerance),
                literal(self.request.scale())
            );
        }
        let _ = write!(
            out,
            "\n   The functions allocate nothing and have no state; they may be called from any thread.\n   C99 and C++; \
             compile without -ffast-math. */\n#ifndef {upper}_H\n#define {upper}_H\n\n"
        );
        if self.has().batch {
            out += "#include <stddef.h>\n\n";
        }
        out += "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n";
        let _ = writeln!(
            out,
            "/* Number of positions. */\n#define {upper}_POSITIONS {}\n",
            self.functions.tree.inputs
        );
        let _ = write!(
            out,
            "/* SHA-256 of the model file. */\n#define {upper}_MODEL \"{}\"\n\n",
            self.request.model_hash
        );
        let _ = write!(
            out,
            "enum {n}_status {{\n    {upper}_OK = 0,\n    /* No motion closes the gap: m is infinite. */\n    \
             {upper}_IMMOVABLE = 1,\n    /* An angle is beyond {} rad, or a number is not finite. */\n    {upper}_RANGE = 2,\n",
            literal(LARGEST_ANGLE)
        );
        let _ = write!(
            out,
            "    /* The positions do not close the loops. */\n    {upper}_OPEN = 3,\n    /* The loops are at a dead centre \
             of the independent joints, or have another rank. */\n    {upper}_SINGULAR = 4,\n    /* The line that defines \
             the normal is too short. */\n    {upper}_LINE = 5\n}};\n\n"
        );
        let _ = write!(
            out,
            "/* Effective mass m, kg. Returns a status; m is NAN unless the status is {upper}_OK, and INFINITY for an\n   \
             immovable contact. */\nint {n}_mass(const double *q, double *mass);\n"
        );
        if self.has().velocity {
            let outputs = &self.functions.velocities;
            let _ = write!(
                out,
                "\n/* Effective mass, and velocities v of the joints at unit closing speed, of least kinetic energy; an \
                 impulse p\n   changes the velocities by -v p/m.\n{}*/\n#define {upper}_VELOCITIES {}\nint \
                 {n}_velocity(const double *q, double *mass, double *v);\n",
                self.output_rows("v", outputs, true),
                outputs.len()
            );
        }
        if self.has().gradient {
            let outputs = &self.functions.gradient;
            let along = if self.functions.closure.is_some() {
                " along the motions of the closed loops,\n   each at unit rate of one independent joint"
            } else {
                " at unit rate of each joint"
            };
            let _ = write!(
                out,
                "\n/* Effective mass, and its derivatives{along}.\n{}*/\n#define {upper}_DERIVATIVES {}\nint \
                 {n}_gradient(const double *q, double *mass, double *derivatives);\n",
                self.output_rows("derivatives", outputs, false),
                outputs.len()
            );
        }
        if self.has().mobility {
            let _ = write!(
                out,
                "\n/* Matrix F = J M^-1 J^T of the link at the contact point, 6 x 6, symmetric, in the axes of the link: \
                 moments first,\n   then forces. 1/m = n^T F n of the lower right block; 0 along an immovable direction. \
                 */\nint {n}_mobility(const double *q, double *mobility);\n"
            );
        }
        if self.has().batch {
            let _ = write!(
                out,
                "\n/* Effective masses of n configurations. Position i of configuration k is q[i*stride + k]. Returns the \
                 number of\n   configurations without a result; their m is NAN, or INFINITY for an immovable contact. \
                 */\nsize_t {n}_batch(size_t n, const double *q, size_t stride, double *mass);\n"
            );
        }
        if self.has().close {
            let drivers: Vec<String> = self
                .functions
                .drivers
                .iter()
                .map(|id| format!("\"{}\"", plain(self.request.system.mechanism().joint(*id).name())))
                .collect();
            let _ = write!(
                out,
                "\n/* Closes the loops by at most {NEWTON_STEPS} Newton steps: q holds the positions of the driving \
                 joints ({})\n   and previous values of the others, which are replaced. residual: root of the sum of \
                 squares of the residuals, m.\n   On another status than {upper}_OK, q is not closed. */\nint \
                 {n}_close(double *q, double *residual);\n",
                drivers.join(", ")
            );
        }
        out += "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
        out
    }

    fn source(&self) -> String {
        let mut out = String::from("/* ");
        out += &header_lines(self.request)[..2].join(" ");
        let _ = write!(out, " */\n#include \"{}.h\"\n\n#include <math.h>\n\n{NO_FAST_MATH}\n", self.name);
        let mass = self.functions.mass_statements();
        if !mass.angles.is_empty() {
            out += &SINE_COSINE.replace('@', self.name);
            out.push('\n');
        }
        out += &self.mass_function("mass", "", &mass, |_| String::new());
        if self.has().velocity {
            let outputs = &self.functions.velocities;
            let statements = self.functions.statements_with(outputs.iter());
            out += &self.mass_function("velocity", ", double *v", &statements, |printer| {
                let assign = |(k, o): (usize, &NamedOutput)| {
                    format!("    v[{k}] = m*({});\n", printer.result(o.value))
                };
                outputs.iter().enumerate().map(assign).collect()
            });
        }
        if self.has().gradient {
            let outputs = &self.functions.gradient;
            let statements = self.functions.statements_with(outputs.iter());
            out += &self.mass_function("gradient", ", double *derivatives", &statements, |printer| {
                let assign = |(k, o): (usize, &NamedOutput)| {
                    format!("    derivatives[{k}] = -m*m*({});\n", printer.result(o.value))
                };
                outputs.iter().enumerate().map(assign).collect()
            });
        }
        if self.has().mobility {
            out += &self.mobility_function();
        }
        if self.has().batch {
            out += &self.batch_function();
        }
        if self.has().close {
            out += &self.close_function();
        }
        out.truncate(out.trim_end().len());
        out.push('\n');
        out
    }

    /// Names of inputs, sines and cosines in arrays, passed to `print`.
    fn with_printer<R>(&self, statements: &Statements, print: impl FnOnce(&Printer) -> R) -> R {
        let names = Names {
            input: &|i| format!("q[{i}]"),
            sine: &|k| format!("s[{k}]"),
            cosine: &|k| format!("c[{k}]"),
            root: &|text| format!("sqrt({text})"),
        };
        print(&Printer { graph: &self.functions.graph, statements, names })
    }

    /// Declarations of the sines, the cosines and the variables.
    fn preparation(&self, printer: &Printer, indent: &str) -> String {
        let statements = printer.statements;
        let mut out = String::new();
        let _ = writeln!(out, "{indent}double range = 0.0;");
        if !statements.angles.is_empty() {
            let n = statements.angles.len();
            let angles: Vec<String> = statements.angles.iter().map(|a| printer.angle(*a)).collect();
            let list = wrapped_list(&angles, 8);
            let _ = write!(
                out,
                "{indent}const double angle[{n}] = {{{list}}};\n{indent}double s[{n}], c[{n}];\n{indent}int i;\n{indent}for \
                 (i = 0; i < {n}; ++i) {{\n{indent}    {}_sine_cosine(angle[i], &s[i], &c[i]);\n{indent}}}\n{indent}for (i = \
                 0; i < {n}; ++i) {{\n{indent}    range += angle[i]*angle[i];\n{indent}}}\n",
                self.name
            );
        }
        for &variable in &statements.variables {
            let name = statements.names[variable.index()].unwrap_or(0);
            let _ = writeln!(out, "{indent}const double x{name} = {};", printer.definition(variable));
        }
        out
    }

    /// Checks of the range and the loops, and of the line of the normal if `with_line`; a failed check returns.
    fn checks(&self, printer: &Printer, indent: &str, with_line: bool) -> String {
        let upper = self.name.to_uppercase();
        let check = |(condition, status): (String, &str)| {
            let status = status.to_uppercase();
            format!("{indent}if (!({condition})) {{\n{indent}    return {upper}_{status};\n{indent}}}\n")
        };
        conditions(self.functions, printer, with_line).into_iter().map(check).collect()
    }

    /// Function that returns a status and m̄, with further results.
    fn mass_function(
        &self,
        name: &str,
        parameters: &str,
        statements: &Statements,
        further: impl FnOnce(&Printer) -> String,
    ) -> String {
        let (n, upper) = (self.name, self.name.to_uppercase());
        self.with_printer(statements, |printer| {
            let mut out = format!("int {n}_{name}(const double *q, double *mass{parameters})\n{{\n");
            if self.uses_no_input(statements) {
                out += "    (void)q;\n";
            }
            out += &self.preparation(printer, "    ");
            let _ = write!(out, "    const double response = {};\n    *mass = NAN;\n", printer.result(self.functions.response));
            out += &self.checks(printer, "    ", true);
            let _ = write!(
                out,
                "    if (!(response < INFINITY)) {{\n        return {upper}_RANGE;\n    }}\n    if (!(response > {})) {{\n        \
                 *mass = INFINITY;\n        return {upper}_IMMOVABLE;\n    }}\n",
                literal(self.functions.immovable)
            );
            let further = further(printer);
            if further.is_empty() {
                out += "    *mass = 1.0/response;\n";
            } else {
                let _ = write!(out, "    const double m = 1.0/response;\n    *mass = m;\n{further}");
            }
            let _ = write!(out, "    return {upper}_OK;\n}}\n\n");
            out
        })
    }

    /// True if no statement reads a position.
    fn uses_no_input(&self, statements: &Statements) -> bool {
        statements.angles.is_empty()
            && self.with_printer(statements, |printer| {
                let reads = |e: &Expr| printer.definition(*e).contains("q[");
                !statements.variables.iter().any(reads)
                    && !printer.result(self.functions.response).contains("q[")
            })
    }

    /// Function that writes the 6×6 matrix J M⁻¹ Jᵀ of the contact link.
    fn mobility_function(&self) -> String {
        let (n, upper) = (self.name, self.name.to_uppercase());
        let mut results: Vec<Expr> =
            [self.functions.closure, self.functions.choice].into_iter().flatten().collect();
        results.extend(&self.functions.mobility);
        let statements = Statements::new(&self.functions.graph, &results);
        self.with_printer(&statements, |printer| {
            let mut out = format!("int {n}_mobility(const double *q, double *mobility)\n{{\n");
            if statements.angles.is_empty() && !statements.variables.iter().any(|e| printer.definition(*e).contains("q["))
            {
                out += "    (void)q;\n";
            }
            out += &self.preparation(printer, "    ");
            out += &self.checks(printer, "    ", false);
            for (k, entry) in self.functions.mobility.iter().enumerate() {
                let _ = writeln!(out, "    mobility[{k}] = {};", printer.result(*entry));
            }
            let _ = write!(
                out,
                "    {{\n        double sum = 0.0;\n        int k;\n        for (k = 0; k < 36; ++k) {{\n            sum += \
                 mobility[k];\n        }}\n        return sum - sum == 0.0 ? {upper}_OK : {upper}_RANGE;\n    }}\n}}\n\n"
            );
            out
        })
    }

    /// Function for many configurations, written so that the compiler vectorises its loop.
    fn batch_function(&self) -> String {
        let n = self.name;
        let statements = self.functions.mass_statements();
        let used = used_inputs(self.functions, &statements);
        let names = Names {
            input: &|i| format!("a{i}"),
            sine: &|k| format!("s{k}"),
            cosine: &|k| format!("c{k}"),
            root: &|text| format!("sqrt({text})"),
        };
        let printer = Printer { graph: &self.functions.graph, statements: &statements, names };
        let mut out = String::from("#if defined(__cplusplus)\n#define ");
        let restrict = format!("{}_RESTRICT", n.to_uppercase());
        let _ = write!(out, "{restrict} __restrict\n#else\n#define {restrict} restrict\n#endif\n\n");
        let _ = write!(
            out,
            "/* 1/response, and a number that is at most 1 for a valid configuration. The loop has no branches, so that \
             compilers\n   vectorise it. */\nstatic void {n}_lanes(size_t n, const double *{restrict} q, size_t stride, double \
             *{restrict} inverse,\n    double *{restrict} check)\n{{\n    size_t k;\n"
        );
        for &i in &used {
            let _ = writeln!(out, "    const double *{restrict} q{i} = q + {i}*stride;");
        }
        if used.is_empty() {
            out += "    (void)q;\n    (void)stride;\n";
        }
        out += "    for (k = 0; k < n; ++k) {\n";
        for &i in &used {
            let _ = writeln!(out, "        const double a{i} = q{i}[k];");
        }
        let mut range = Vec::new();
        for (k, angle) in statements.angles.iter().enumerate() {
            let text = printer.angle(*angle);
            let _ = write!(
                out,
                "        double s{k}, c{k};\n        const double b{k} = {text};\n        {n}_sine_cosine(b{k}, &s{k}, &c{k});\n"
            );
            range.push(format!("b{k}*b{k}"));
        }
        for &variable in &statements.variables {
            let name = statements.names[variable.index()].unwrap_or(0);
            let _ = writeln!(out, "        const double x{name} = {};", printer.definition(variable));
        }
        let _ = writeln!(out, "        const double response = {};", printer.result(self.functions.response));
        let range = if range.is_empty() { "0.0".to_owned() } else { range.join(" + ") };
        let limit = literal(1.0 / (LARGEST_ANGLE * LARGEST_ANGLE));
        let _ = writeln!(out, "        double worst = {limit}*({range});");
        let limits = [self.functions.line, self.functions.closure, self.functions.choice];
        for (number, limit) in limits.into_iter().flatten().enumerate() {
            // The larger of two numbers without a comparison; NAN if one is NAN.
            let _ = write!(
                out,
                "        const double y{number} = {};\n        worst = 0.5*(worst + y{number} + fabs(worst - y{number}));\n",
                printer.result(limit)
            );
        }
        let _ = write!(
            out,
            "        inverse[k] = 1.0/response;\n        check[k] = worst;\n    }}\n}}\n\nsize_t {n}_batch(size_t n, const double \
             *q, size_t stride, double *mass)\n{{\n    double check[{BLOCK}];\n    size_t first, k, failed = 0;\n    for (first = 0; \
             first < n; first += {BLOCK}) {{\n        const size_t count = n - first < {BLOCK} ? n - first : {BLOCK};\n        double *m = \
             mass + first;\n        {n}_lanes(count, q + first, stride, m, check);\n        for (k = 0; k < count; ++k) {{\n            if \
             (check[k] <= 1.0 && m[k] > 0.0 && m[k] < {largest}) {{\n                continue;\n            }}\n            ++failed;\n            \
             m[k] = check[k] <= 1.0 && (m[k] < 0.0 || m[k] >= {largest}) ? INFINITY : NAN;\n        }}\n    }}\n    return \
             failed;\n}}\n\n",
            largest = literal(1.0 / self.functions.immovable)
        );
        out
    }

    /// Function that closes the loops by Newton steps on the dependent positions.
    fn close_function(&self) -> String {
        let (n, upper) = (self.name, self.name.to_uppercase());
        let functions = self.functions;
        let mut results: Vec<Expr> = [functions.closure, functions.choice].into_iter().flatten().collect();
        results.extend(functions.steps.iter().map(|step| step.value));
        let statements = Statements::new(&functions.graph, &results);
        let closure = functions.closure;
        let count = functions.steps.len();
        let scale = self.request.scale();
        self.with_printer(&statements, |printer| {
            let text = |e: Option<Expr>| e.map_or_else(|| "0.0".to_owned(), |e| printer.result(e));
            let mut out = format!(
                "int {n}_close(double *q, double *residual)\n{{\n    int iteration, is_last = 0;\n    *residual = NAN;\n    for \
                 (iteration = 0; iteration <= {NEWTON_STEPS}; ++iteration) {{\n"
            );
            out += &self.preparation(printer, "        ");
            let _ = write!(
                out,
                "        const double closure = {};\n        const double choice = {};\n        *residual = {}*sqrt(closure);\n",
                text(closure),
                text(functions.choice),
                literal(functions.closure_tolerance)
            );
            let _ = write!(
                out,
                "        if (!(range <= {})) {{\n            return {upper}_RANGE;\n        }}\n        if (is_last) {{\n            \
                 if (!(choice <= 1.0)) {{\n                return {upper}_SINGULAR;\n            }}\n            return closure <= \
                 1.0 ? {upper}_OK : {upper}_OPEN;\n        }}\n",
                literal(LARGEST_ANGLE * LARGEST_ANGLE)
            );
            let steps: Vec<String> = functions.steps.iter().map(|s| printer.result(s.value)).collect();
            let list = wrapped_list(&steps, 16);
            let _ = writeln!(out, "        double step[{count}] = {{{list}}};");
            let lengths: Vec<String> = functions.steps.iter().map(|s| literal(s.length(scale))).collect();
            let _ = write!(
                out,
                "        const double length[{count}] = {{{}}};\n        double square = 0.0;\n        int k;\n        for (k = 0; \
                 k < {count}; ++k) {{\n            square += step[k]*step[k]*length[k]*length[k];\n        }}\n        if (!(square < \
                 INFINITY)) {{\n            return {upper}_SINGULAR;\n        }}\n        if (square > {largest}) {{\n            \
                 /* Long steps are shortened. */\n            const double factor = sqrt({largest}/square);\n            for (k = 0; \
                 k < {count}; ++k) {{\n                step[k] *= factor;\n            }}\n        }}\n        is_last = square < {least};\n",
                wrapped_list(&lengths, 16),
                largest = literal((0.5 * scale).powi(2)),
                least = literal((1e-9 * scale).powi(2)),
            );
            out += &self.position_updates();
            let _ = write!(out, "    }}\n    return {upper}_OPEN;\n}}\n\n");
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
            let [a, b, c, d] = match kind {
                JointKind::Floating => [3, 4, 5, 6],
                _ => [0, 1, 2, 3],
            }
            .map(|k| format!("q[{}]", first + k));
            let _ = write!(
                out,
                "        {{\n            const double w = {a}, x = {b}, y = {c}, z = {d};\n            const double u0 = 0.5*{}, u1 \
                 = 0.5*{}, u2 = 0.5*{};\n",
                of(0),
                of(1),
                of(2)
            );
            if kind == JointKind::Floating {
                let (v0, v1, v2) = (of(3), of(4), of(5));
                let _ = write!(
                    out,
                    "            const double v0 = {v0}, v1 = {v1}, v2 = {v2};\n            q[{first}] += (1.0 - 2.0*(y*y + \
                     z*z))*v0 + 2.0*(x*y - w*z)*v1 + 2.0*(x*z + w*y)*v2;\n            q[{}] += 2.0*(x*y + w*z)*v0 + (1.0 - \
                     2.0*(x*x + z*z))*v1 + 2.0*(y*z - w*x)*v2;\n            q[{}] += 2.0*(x*z - w*y)*v0 + 2.0*(y*z + w*x)*v1 + (1.0 \
                     - 2.0*(x*x + y*y))*v2;\n",
                    first + 1,
                    first + 2
                );
            }
            let _ = write!(
                out,
                "            const double e0 = w - x*u0 - y*u1 - z*u2;\n            const double e1 = x + w*u0 + y*u2 - \
                 z*u1;\n            const double e2 = y + w*u1 - x*u2 + z*u0;\n            const double e3 = z + w*u2 + x*u1 - \
                 y*u0;\n            const double norm = 1.0/sqrt(e0*e0 + e1*e1 + e2*e2 + e3*e3);\n            {a} = e0*norm;\n            \
                 {b} = e1*norm;\n            {c} = e2*norm;\n            {d} = e3*norm;\n        }}\n"
            );
        }
        out
    }
}
