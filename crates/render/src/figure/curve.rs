//! Converts a series to polylines on the page: broken at gaps, thinned to the resolution of the page.

use crate::figure::axis::drawable;
use crate::limits;
use crate::scene::Point;
use std::collections::HashSet;

/// Series in page coordinates.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Curve {
    /// Polylines of two points or more.
    pub chains: Vec<Vec<Point>>,
    /// Points between two gaps.
    pub isolated: Vec<Point>,
}

/// Upper left and lower right corner of a rectangle.
pub(crate) type Corners = (Point, Point);

/// True if the point is in the rectangle or on an edge.
pub(crate) fn is_inside(p: Point, (from, to): Corners) -> bool {
    (from.0..=to.0).contains(&p.0) && (from.1..=to.1).contains(&p.1)
}

impl Curve {
    /// Clips the curve to a rectangle.
    pub fn clipped_to(self, corners: Corners) -> Curve {
        let chains = self.chains.iter().flat_map(|chain| clip_polyline(chain, corners)).collect();
        Curve { chains, isolated: self.isolated.into_iter().filter(|p| is_inside(*p, corners)).collect() }
    }
}

/// Clips a polyline to a rectangle (Liang and Barsky 1984).
fn clip_polyline(chain: &[Point], (from, to): Corners) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    for pair in chain.windows(2) {
        let ((x, y), (dx, dy)) = (pair[0], (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1));
        let (mut t_entry, mut t_exit) = (0.0_f64, 1.0_f64);
        for (step, distance) in [(-dx, x - from.0), (dx, to.0 - x), (-dy, y - from.1), (dy, to.1 - y)] {
            match step {
                0.0 if distance < 0.0 => t_exit = -1.0,
                0.0 => {}
                step if step < 0.0 => t_entry = t_entry.max(distance / step),
                step => t_exit = t_exit.min(distance / step),
            }
        }
        if t_entry > t_exit {
            continue;
        }
        let at = |t: f64| ((x + t * dx).clamp(from.0, to.0), (y + t * dy).clamp(from.1, to.1));
        match parts.last_mut().filter(|part| t_entry == 0.0 && part.last() == Some(&pair[0])) {
            Some(part) => part.push(at(t_exit)),
            None => parts.push(vec![at(t_entry), at(t_exit)]),
        }
    }
    parts
}

/// Converts points to polylines, with a gap at each missing value; `to_page` maps values to the page.
pub(crate) fn polylines(points: &[(f64, Option<f64>)], to_page: impl Fn(f64, f64) -> Point) -> Curve {
    let map_point = |&(x, y): &(f64, Option<f64>)| Some(to_page(drawable(x)?, drawable(y?)?));
    let points_on_page: Vec<Option<Point>> = points.iter().map(map_point).collect();
    let runs = points_on_page.split(Option::is_none).filter(|run| !run.is_empty());
    let (mut chains, mut isolated) = (Vec::new(), Vec::new());
    for run in runs {
        let run: Vec<Point> = run.iter().copied().flatten().collect();
        match run[..] {
            [only] => isolated.push(only),
            _ => chains.push(envelope(&run)),
        }
    }
    // Too many chains, or a line that crosses many columns repeatedly: thin evenly, keeping the ends.
    let most_chains = limits::MAX_POINTS / 4;
    let chains = thin_evenly(chains, most_chains);
    let share = limits::MAX_POINTS / chains.len().max(1);
    let chains = chains.into_iter().map(|chain| thin_evenly(chain, share.max(2))).collect();
    Curve { chains, isolated: merge_dots(isolated) }
}

/// Converts points to dots; dots at nearly the same position are merged.
pub(crate) fn merged_dots(points: &[(f64, Option<f64>)], to_page: impl Fn(f64, f64) -> Point) -> Vec<Point> {
    merge_dots(points.iter().filter_map(|&(x, y)| Some(to_page(drawable(x)?, drawable(y?)?))).collect())
}

/// Keeps the first, lowest, highest and last of consecutive points in one column of half a page unit, so that the picture,
/// peaks included, does not change visibly.
fn envelope(run: &[Point]) -> Vec<Point> {
    let column = |p: &Point| (p.0 / limits::COLUMN).floor();
    let mut kept = Vec::new();
    for group in run.chunk_by(|a, b| column(a) == column(b)) {
        let by_height = |&a: &usize, &b: &usize| group[a].1.total_cmp(&group[b].1);
        let last = group.len() - 1;
        let low = (0..=last).min_by(by_height).unwrap_or(0);
        let high = (0..=last).max_by(by_height).unwrap_or(0);
        let mut chosen = [0, low.min(high), low.max(high), last].to_vec();
        chosen.dedup();
        kept.extend(chosen.into_iter().map(|i| group[i]));
    }
    kept
}

/// Keeps one dot per cell of half a page unit.
fn merge_dots(points_on_page: Vec<Point>) -> Vec<Point> {
    let mut taken = HashSet::new();
    let cell = |p: &Point| ((p.0 / limits::COLUMN).round() as i64, (p.1 / limits::COLUMN).round() as i64);
    thin_evenly(points_on_page.into_iter().filter(|p| taken.insert(cell(p))).collect(), limits::MAX_POINTS)
}

/// Thins a list evenly to `max_count` elements, keeping the first and the last.
fn thin_evenly<T>(all: Vec<T>, max_count: usize) -> Vec<T> {
    if all.len() <= max_count {
        return all;
    }
    let (last, steps) = (all.len() - 1, max_count - 1);
    let mut indices = (0..max_count).map(|i| i * last / steps).peekable();
    let chosen = all.into_iter().enumerate().filter(|(i, _)| indices.next_if_eq(i).is_some());
    chosen.map(|(_, item)| item).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn as_is(x: f64, y: f64) -> Point {
        (x, y)
    }

    #[test]
    fn a_line_has_gaps_at_missing_values_and_nan() {
        let points = [
            (0.0, Some(1.0)),
            (1.0, Some(2.0)),
            (2.0, None),
            (3.0, Some(4.0)),
            (4.0, Some(f64::NAN)),
            (5.0, Some(6.0)),
            (f64::INFINITY, Some(6.0)),
            (7.0, Some(8.0)),
            (8.0, Some(9.0)),
        ];
        let curve = polylines(&points, as_is);
        assert_eq!(curve.chains, [vec![(0.0, 1.0), (1.0, 2.0)], vec![(7.0, 8.0), (8.0, 9.0)]]);
        assert_eq!(curve.isolated, [(3.0, 4.0), (5.0, 6.0)]);
        assert_eq!(merged_dots(&points, as_is).len(), 6);
    }

    #[test]
    fn a_chain_is_cut_at_the_edges() {
        let corners = ((0.0, 0.0), (10.0, 10.0));
        let chain = [(-5.0, 5.0), (5.0, 5.0), (5.0, 8.0), (5.0, 20.0), (15.0, 5.0), (5.0, -5.0)];
        let parts = clip_polyline(&chain, corners);
        assert_eq!(parts[0], [(0.0, 5.0), (5.0, 5.0), (5.0, 8.0), (5.0, 10.0)]);
        assert!(parts.iter().flatten().all(|p| is_inside(*p, corners)));
        assert_eq!(parts.last().map(|part| part.len()), Some(2));
        assert!(clip_polyline(&[(-1.0, -1.0), (-1.0, 11.0), (20.0, 11.0)], corners).is_empty());
    }

    #[test]
    fn thinning_keeps_the_peak() {
        let spike = |i: usize| if i == 54_321 { 100.0 } else { (i as f64 * 0.1).sin() };
        let points: Vec<_> = (0..100_000).map(|i| (i as f64 * 0.008, Some(spike(i)))).collect();
        let curve = polylines(&points, as_is);
        assert!(curve.chains[0].len() <= limits::MAX_POINTS);
        assert!(curve.chains[0].iter().any(|p| p.1 == 100.0));
        assert_eq!(curve.chains[0].first(), Some(&(0.0, 0.0)));
        assert_eq!(curve.chains[0].last().map(|p| p.0), points.last().map(|p| p.0));
    }

    #[test]
    fn the_size_is_bounded_for_every_input() {
        // A line that crosses the whole width at each step, and a line with a gap after every two points.
        let zigzag: Vec<_> = (0..200_000).map(|i| (f64::from(i % 2) * 800.0, Some(f64::from(i)))).collect();
        let broken: Vec<_> =
            (0..200_000).map(|i| (f64::from(i) * 1e-2, (i % 3 != 0).then_some(1.0))).collect();
        for points in [zigzag, broken] {
            let curve = polylines(&points, as_is);
            let points_on_page: usize = curve.chains.iter().map(Vec::len).sum();
            assert!(points_on_page <= limits::MAX_POINTS && points_on_page > 1_000, "{points_on_page}");
            assert!(merged_dots(&points, as_is).len() <= limits::MAX_POINTS);
        }
        assert_eq!(thin_evenly((0..10).collect(), 4), [0, 3, 6, 9]);
    }
}
