//! Evaluation of one contact at many rows of positions, with loops closed along one branch. Rows are handed out
//! in order and are not stored.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::checks::joint_limits::many_turns_finding;
use crate::evaluation::named_contact::findings_at_touch;
use crate::evaluation::passed_stops::PassedStops;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::evaluation::random_rows::RandomRows;
use crate::evaluation::status::mass_unit;
use crate::model::loading::Model;
use crate::model::record::DiagnosticRecord;
use crate::pose::positions::PoseLayout;
use crate::pose::unreachable_range::SkippedRows;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::mass_question::MassQuestion;
use crate::question::row_source::RowSource;
use crate::question::travel::given_travel::GivenTravel;
use crate::question::travel::varied_values::VariedColumn;
use crate::question::travel::vary::{Varied, Vary};
use crate::sweep::continuation;
use crate::sweep::pipeline;
use crate::sweep::plain_rows::TreeRows;
use crate::sweep::row_blocks::RowReader;
use crate::sweep::row_gradient::GradientLayout;
use crate::sweep::row_layout::RowLayout;
use crate::sweep::sweep_context::SweepContext;
use crate::sweep::sweep_report::{Continuation, SweepEnd, SweepHeading, SweepReport, SweepRow};
use crate::tables::trajectory::Trajectory;
use crate::thresholds::{GRID_ROWS, MOST_TURNS_VARIED, ROWS};
use percuss_dynamics::Gap;
use percuss_mechanism::Mechanism;
use std::ops::ControlFlow;
use std::sync::Arc;

/// Prepared sweep: resolved names, checked numbers, known contact.
#[derive(Debug)]
pub struct Sweep<'a> {
    context: SweepContext<'a>,
    rows: RowReader,
    /// Findings about the ranges and the contact point, known before the rows.
    findings: Vec<Finding>,
}

/// Evaluates a contact at many rows of positions; `each` receives the rows and may end the sweep.
///
/// A point given in another frame than the contact link's frame is converted once, at the pose of the question
/// with all varied values at 0, and is then fixed to the link. The conversion is independent of the rows. An
/// unreachable row has an error message, and the sweep continues from the last row reached; rows known to lie
/// beyond the end of the branch are not tried.
///
/// # Errors
/// [`StudyError`]: unknown names, a quantity that cannot be varied, an invalid contact.
pub fn sweep(
    model: &Model,
    question: &MassQuestion,
    source: impl Into<RowSource>,
    each: &mut dyn FnMut(SweepRow) -> ControlFlow<()>,
) -> Result<SweepEnd, StudyError> {
    Sweep::new(model, question, source)?.run(each)
}

/// Sweep with all rows in memory, some hundred bytes each.
///
/// # Errors
/// [`StudyError`], as for [`sweep()`].
pub fn sweep_report(
    model: &Model,
    question: &MassQuestion,
    source: impl Into<RowSource>,
) -> Result<SweepReport, StudyError> {
    Sweep::new(model, question, source)?.report()
}

impl<'a> Sweep<'a> {
    /// Runs the sweep; all rows in memory, some hundred bytes each.
    ///
    /// # Errors
    /// As for [`run`](Self::run).
    pub fn report(self) -> Result<SweepReport, StudyError> {
        let model = self.context.prepared.model;
        let heading = self.heading().clone();
        let mut rows = Vec::new();
        let end = self.run(&mut |row| {
            rows.push(row);
            ControlFlow::Continue(())
        })?;
        let diagnostics = model.diagnostics.iter().cloned().chain(end.diagnostics).collect();
        Ok(SweepReport { heading, rows, diagnostics })
    }

    /// Prepares a sweep.
    ///
    /// # Errors
    /// [`StudyError`], as for [`sweep()`], as far as errors are detectable without rows.
    pub fn new(
        model: &'a Model,
        question: &'a MassQuestion,
        source: impl Into<RowSource>,
    ) -> Result<Self, StudyError> {
        let prepared = PreparedQuestion::new(model, question)?;
        let mut findings = Vec::new();
        let (setting, rows) = match append_travel(&prepared, source.into())? {
            RowSource::Grid(ranges) => {
                let turns = ranges.iter().filter_map(|range| many_turns(&model.mechanism, range));
                findings.extend(turns);
                grid(&prepared, &ranges)?
            }
            RowSource::File(file) => {
                let refuse = |error| StudyError::input("sweep.input", Fault::Table(Box::new(error)));
                let trajectory = Trajectory::open(&prepared, &file).map_err(refuse)?;
                let setting = RowLayout::from_joints(&prepared, trajectory.joints(), "sweep.input");
                (setting, RowReader::File(Box::new(trajectory)))
            }
            RowSource::Random { count, seed } => {
                if count == 0 || count > GRID_ROWS {
                    let why = format!("{count} random rows; 1 to {GRID_ROWS} are possible");
                    return Err(StudyError::input("sweep.random", why));
                }
                let random = RandomRows::new(&prepared, count, seed)?;
                (RowLayout::from_joints(&prepared, &random.joints, "sweep.random"), RowReader::Random(random))
            }
        };
        let seed = match &rows {
            RowReader::Random(random) => Some(random.seed),
            RowReader::Grid(_) | RowReader::File(_) => None,
        };
        let mut inputs = prepared.inputs();
        if let RowReader::File(file) = &rows {
            inputs.push(file.input.clone());
        }
        let travel = if setting.travels() && setting.width() == 1 {
            setting.travel(&prepared.system, &[0.0])?.map(Arc::new)
        } else {
            None
        };
        let contact = match prepared.pose_independent_contact() {
            Some(contact) => contact,
            None => {
                let travel = travel.as_ref().map(|travel| &travel.0);
                let reference = continuation::reference(&prepared.system, &setting, travel);
                let is_varied = |joint: &str| is_varied(&setting.columns, joint);
                prepared.contact_at(&reference.map_err(|error| error.into_varied_fault(is_varied))?)
            }
        };
        findings.extend(
            prepared
                .converted_point_finding(&contact, &format!("where {} is 0", setting.varied_description())),
        );
        findings.extend(findings_at_touch(model, question));
        let gap = match prepared.question.named_contact(&model.mechanism)? {
            // The gap depends on the drawing only; a model that does not close as drawn has no rows either.
            Some(contact) => {
                let drawn = prepared.system.pose(&prepared.system.configuration()).ok();
                drawn.and_then(|pose| Some((Gap::new(&pose, contact)?, pose)))
            }
            None => None,
        };
        let heading = SweepHeading {
            schema: "percuss.sweep/2",
            percuss: env!("CARGO_PKG_VERSION"),
            inputs,
            varied: setting.columns.to_vec(),
            continuation: continuation(&prepared, &rows),
            seed,
            link: prepared.question.contact.link().to_owned(),
            unit: mass_unit(contact.normal.is_moment()),
            contact: prepared.question.contact.at.clone(),
            motion_ratio_of: motion_ratio_of(&prepared, &setting),
            joints: PoseLayout::new(&model.mechanism),
            has_gap: gap.is_some(),
            length_unit: model.length_unit(),
            gradient: None,
        };
        let (along, lanes) = (rows.distance_measure(), TreeRows::new(&prepared, &setting, &contact));
        let passed_stops = match setting.moved() {
            Some(moved) => PassedStops::of_travels(&prepared, [moved]),
            None => PassedStops::of_joints(&prepared),
        };
        let context = SweepContext {
            prepared,
            row_layout: setting,
            travel,
            contact,
            heading,
            distance_measure: along,
            gap,
            passed_stops,
            tree_rows: lanes,
        };
        Ok(Self { context, rows, findings })
    }

    /// The same sweep with the gradient of m̄ at each row.
    ///
    /// The gradient g has one number per velocity of all joints, at a fixed contact: dm̄/dt = Σ g q̇ for every admissible motion. In a
    /// mechanism with loops, where the velocities depend on each other, only this sum is defined.
    #[must_use]
    pub fn with_gradient(mut self) -> Self {
        let mechanism = self.context.prepared.system.mechanism();
        self.context.heading.gradient = Some(GradientLayout::new(mechanism));
        self.context.tree_rows = self.context.tree_rows.map(TreeRows::with_gradient);
        self
    }

    /// Heading: data common to all rows.
    pub fn heading(&self) -> &SweepHeading {
        &self.context.heading
    }

    /// Number of rows, if known.
    pub fn count(&self) -> Option<usize> {
        self.rows.count()
    }

    /// Computes the rows; `each` receives the rows in order and may end the sweep.
    ///
    /// # Errors
    /// [`StudyError`], as for [`sweep()`], before the first row with a result. Later errors are recorded in
    /// their rows.
    pub fn run(self, each: &mut dyn FnMut(SweepRow) -> ControlFlow<()>) -> Result<SweepEnd, StudyError> {
        self.run_with_conversion(&|row| row, each)
    }

    /// Same as [`run`](Self::run), but `each` receives the values of `convert(row)`. Any thread of rayon's pool
    /// may call `convert`, in any order.
    ///
    /// # Errors
    /// As for [`run`](Self::run).
    pub fn run_with_conversion<T: Send>(
        self,
        convert: &(dyn Fn(SweepRow) -> T + Sync),
        each: &mut dyn FnMut(T) -> ControlFlow<()>,
    ) -> Result<SweepEnd, StudyError> {
        let Self { context, rows, findings } = self;
        let result = pipeline::run(&context, rows, convert, each)
            .map_err(|error| error.into_varied_fault(|joint| is_varied(&context.heading.varied, joint)))?;
        let mut end = result.end;
        let of_all =
            findings.into_iter().chain(continuation_finding(&context.prepared, context.heading.continuation));
        let of_all = of_all.chain(result.skipped.map(skipped_rows_finding));
        end.diagnostics =
            of_all.map(DiagnosticRecord::from).chain(result.tally.into_records(end.rows)).collect();
        Ok(end)
    }
}

/// Motion of the motion ratio of the rows; `None` for rows without a motion ratio.
fn motion_ratio_of(prepared: &PreparedQuestion, layout: &RowLayout) -> Option<String> {
    let travel = layout.columns.last().filter(|_| layout.travels()).map(|travel| travel.name.clone());
    travel.or_else(|| prepared.question.contact.estimate.is_some().then(|| "estimate".to_owned()))
}

/// True if a joint is among the varied columns.
fn is_varied(columns: &[VariedColumn], joint: &str) -> bool {
    columns.iter().any(|column| column.joint.as_deref() == Some(joint))
}

/// True if the last range varies a motion of the wheels, and the travels are other motions of the wheels.
fn are_motions_beside_range(travels: &[GivenTravel], ranges: &[Vary]) -> bool {
    let Some(Varied::Travel(varied)) = ranges.last().map(|range| &range.quantity) else { return false };
    travels.iter().all(|travel| travel.moved.is_beside(varied))
}

/// Appends a travel of the question to the ranges, as last range with one value.
fn append_travel(prepared: &PreparedQuestion, source: RowSource) -> Result<RowSource, StudyError> {
    match (&prepared.question.pose.travel[..], source) {
        ([], source) => Ok(source),
        // A constant roll beside a range of heave, or the reverse.
        (travels, RowSource::Grid(ranges)) if are_motions_beside_range(travels, &ranges) => {
            Ok(RowSource::Grid(ranges))
        }
        ([travel], RowSource::Grid(mut ranges))
            if ranges.iter().all(|vary| matches!(vary.quantity, Varied::Joint(_))) =>
        {
            ranges.push(travel.as_range());
            Ok(RowSource::Grid(ranges))
        }
        _ => {
            let why = "a travel of the pose can be combined with ranges of joints only, not with a varied travel, a file of \
                       positions, random positions, or another travel";
            Err(StudyError::input("pose.travel", why))
        }
    }
}

/// Row layout and rows of a grid.
fn grid(prepared: &PreparedQuestion, ranges: &[Vary]) -> Result<(RowLayout, RowReader), StudyError> {
    let refuse = |fault: Fault| StudyError::input("sweep.vary", fault);
    let rows =
        |count| refuse(format!("{count} rows; {} to {} are possible", ROWS.start(), ROWS.end()).into());
    if let Some(vary) = ranges.iter().find(|vary| !ROWS.contains(&vary.count)) {
        return Err(rows(vary.count));
    }
    let count: u128 = ranges.iter().map(|vary| vary.count as u128).fold(1, u128::saturating_mul);
    if ranges.is_empty() {
        return Err(rows(0));
    }
    if ranges.len() > 1 && count > GRID_ROWS as u128 {
        let why = format!("the ranges have {count} combinations; {GRID_ROWS} are possible at most");
        return Err(refuse(why.into()));
    }
    let setting = RowLayout::from_grid(prepared, ranges)?;
    let values = |(column, vary): (usize, &Vary)| {
        vary.values(setting.dimension(column)).map_err(|error| refuse(error.into()))
    };
    let values = ranges.iter().enumerate().map(values).collect::<Result<Vec<_>, _>>()?;
    Ok((setting, RowReader::Grid(values)))
}

/// True if the mechanism has closed loops.
fn has_loops(prepared: &PreparedQuestion) -> bool {
    let system = &prepared.system;
    system.mechanism().joint_ids().any(|joint| system.is_bound(joint))
}

/// Mode in which poses depend on those of earlier rows: independent without loops or with one row per line, otherwise along
/// each line or along all rows.
fn continuation(prepared: &PreparedQuestion, rows: &RowReader) -> Continuation {
    if !has_loops(prepared) {
        return Continuation::Independent;
    }
    match (rows.rows_per_line(), rows.count()) {
        (Some(1), _) => Continuation::Independent,
        (Some(line), Some(all)) if line < all => Continuation::Lines,
        _ => Continuation::Path,
    }
}

/// Finding about a range that turns a joint many times.
fn many_turns(mechanism: &Mechanism, range: &Vary) -> Option<Finding> {
    let Varied::Joint(name) = &range.quantity else { return None };
    let joint = mechanism.find_joint(name).ok()?;
    let ends = [range.from, range.to];
    ends.into_iter()
        .find_map(|end| many_turns_finding(mechanism, joint, end, MOST_TURNS_VARIED, "is varied to"))
}

/// Finding about the continuation of the rows, if the mechanism has loops.
fn continuation_finding(prepared: &PreparedQuestion, continuation: Continuation) -> Option<Finding> {
    if !has_loops(prepared) {
        return None;
    }
    let message = match continuation {
        Continuation::Path => {
            "each row starts from the previous row, with loops on the same branch: the rows are one path"
        }
        Continuation::Lines => {
            "each line of the grid starts at its own first row and varies the last quantity; lines are independent"
        }
        Continuation::Independent => "each row starts from the first closed pose: rows are independent",
    };
    Some(Finding::about_result(FindingKind::RowsFollowed, message))
}

/// Finding with the number of rows that were not tried, and the reason.
fn skipped_rows_finding(untried: SkippedRows) -> Finding {
    let SkippedRows { count, first, found_by } = untried;
    let message = format!(
        "{count} row(s) were not tried, row {first} the first: they are at least as far away as the end of the \
         reachable range found by row {found_by} (the error of that row states the reason)"
    );
    Finding::about_result(FindingKind::RowsNotTried, message)
}
