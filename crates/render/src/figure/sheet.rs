//! Output of figures: one on a page, or several one below the other with separate axes.

use crate::figure::Figure;
use crate::figure::layout;
use crate::picture::Laid;
use crate::scene::{Item, Point, Scene};

impl Laid for Figure {
    /// Figure of 900 page units in width and about 300 in height per panel. The length of its SVG is bounded by the number of series, not
    /// of points.
    fn layout_scene(&self) -> Scene {
        layout::layout_figure(self)
    }
}

/// Figures with separate x axes, stacked on one page.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sheet {
    /// Figures from top to bottom.
    pub figures: Vec<Figure>,
}

impl Laid for Sheet {
    /// Stacks the scenes of the figures on one page.
    fn layout_scene(&self) -> Scene {
        let mut scenes = self.figures.iter().map(layout::layout_figure);
        let Some(mut page) = scenes.next() else { return layout::layout_figure(&Figure::default()) };
        for scene in scenes {
            let down = page.height;
            page.items.extend(scene.items.into_iter().map(|item| shifted_down(item, down)));
            page.width = page.width.max(scene.width);
            page.height += scene.height;
            page.caption = format!("{}; {}", page.caption, scene.caption);
        }
        page
    }
}

/// Item moved down the page by a distance.
fn shifted_down(item: Item, down: f64) -> Item {
    let lower = |(x, y): Point| (x, y + down);
    match item {
        Item::Lines { chains, stroke } => {
            let chains = chains.into_iter().map(|chain| chain.into_iter().map(lower).collect()).collect();
            Item::Lines { chains, stroke }
        }
        Item::Dots { centres, radius, colour } => {
            Item::Dots { centres: centres.into_iter().map(lower).collect(), radius, colour }
        }
        Item::Patch { from, to, colour } => Item::Patch { from: lower(from), to: lower(to), colour },
        Item::Area { corners, colour } => {
            Item::Area { corners: corners.into_iter().map(lower).collect(), colour }
        }
        Item::Image { at, size, pixels, columns } => Item::Image { at: lower(at), size, pixels, columns },
        Item::Hover { at, radius, title } => Item::Hover { at: lower(at), radius, title },
        Item::Text(mut text) => {
            text.at = lower(text.at);
            Item::Text(text)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Picture;
    use crate::{Panel, Series};

    fn figure(title: &str) -> Figure {
        let series = Series { points: vec![(0.0, Some(1.0)), (1.0, Some(2.0))], ..Series::default() };
        Figure {
            title: title.into(),
            panels: vec![Panel { series: vec![series], ..Panel::default() }],
            ..Figure::default()
        }
    }

    #[test]
    fn figures_are_stacked() {
        let (first, second) = (figure("first"), figure("second"));
        let page = Sheet { figures: vec![first.clone(), second.clone()] }.layout_scene();
        let [a, b] = [&first, &second].map(layout::layout_figure);
        assert_eq!(page.height, a.height + b.height);
        assert_eq!(page.items.len(), a.items.len() + b.items.len());
        let position_of = |scene: &Scene, content: &str| {
            scene.items.iter().find_map(|item| match item {
                Item::Text(text) if text.content == content => Some(text.at),
                _ => None,
            })
        };
        let (alone, below) =
            (position_of(&b, "second").expect("drawn"), position_of(&page, "second").expect("drawn"));
        assert_eq!(below, (alone.0, alone.1 + a.height));
        assert_eq!(Sheet { figures: vec![first.clone()] }.to_svg(), first.to_svg());
        assert!(Sheet::default().to_svg().starts_with("<svg"));
    }
}
