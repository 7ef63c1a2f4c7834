//! Writes a scene as PDF: vector content by svg2pdf, images below it.

use super::pdf_objects::in_order_of_use;
use super::tree;
use crate::backend::{MADE_BY, RenderError};
use crate::scene::{Item, Scene};
use crate::svg;
use pdf_writer::{Content, Filter, Finish, Name, Pdf, Rect, Ref};
use std::collections::HashMap;

/// PDF points per page unit (1/96 inch).
const POINTS: f64 = 72.0 / 96.0;

/// Returns the picture as a PDF of one page; text stays text. Images are below all vector content, whatever
/// their order.
pub(crate) fn pdf(scene: &Scene) -> Result<Vec<u8>, RenderError> {
    let made = svg2pdf::to_chunk(&tree(&svg::write_over(scene))?, svg2pdf::ConversionOptions::default());
    let (drawn, drawn_id) = made.map_err(|error| RenderError::Pdf { message: error.to_string() })?;
    let mut next = Ref::new(1);
    let [catalog, pages, page, contents] = std::array::from_fn(|_| next.bump());
    let mut ids = HashMap::new();
    let drawn =
        in_order_of_use(&drawn, drawn_id).renumber(|old| *ids.entry(old).or_insert_with(|| next.bump()));
    let drawn_id = *ids.get(&drawn_id).unwrap_or(&drawn_id);
    let images = scene.items.iter().filter_map(|item| match item {
        Item::Image { at, size, pixels, columns } => Some((*at, *size, pixels, *columns, next.bump())),
        _ => None,
    });
    let images: Vec<_> = images.collect();
    let name = |i: usize| format!("I{i}");
    let (width, height) = ((scene.width * POINTS) as f32, (scene.height * POINTS) as f32);
    let mut file = Pdf::new();
    file.catalog(catalog).pages(pages);
    file.pages(pages).kids([page]).count(1);
    let mut of_page = file.page(page);
    of_page.media_box(Rect::new(0.0, 0.0, width, height)).parent(pages).contents(contents);
    let mut resources = of_page.resources();
    let mut objects = resources.x_objects();
    objects.pair(Name(b"S"), drawn_id);
    for (i, (.., id)) in images.iter().enumerate() {
        objects.pair(Name(name(i).as_bytes()), *id);
    }
    objects.finish();
    resources.finish();
    of_page.finish();
    let mut content = Content::new();
    // An image object is a unit square with y upwards.
    for (i, (at, size, ..)) in images.iter().enumerate() {
        let (w, h) = ((size.0 * POINTS) as f32, (size.1 * POINTS) as f32);
        let (x, y) = ((at.0 * POINTS) as f32, height - (at.1 * POINTS) as f32 - h);
        content
            .save_state()
            .transform([w, 0.0, 0.0, h, x, y])
            .x_object(Name(name(i).as_bytes()))
            .restore_state();
    }
    content.save_state().transform([width, 0.0, 0.0, height, 0.0, 0.0]).x_object(Name(b"S")).restore_state();
    file.stream(contents, &content.finish());
    for (_, _, pixels, columns, id) in images {
        let rows = (pixels.len() / 3).checked_div(columns).unwrap_or(0);
        let packed = miniz_oxide::deflate::compress_to_vec_zlib(&pixels[..3 * columns * rows], 6);
        let mut image = file.image_xobject(id, &packed);
        image.width(columns as i32).height(rows as i32).bits_per_component(8);
        image.color_space().device_rgb();
        image.filter(Filter::FlateDecode);
    }
    file.extend(&drawn);
    let mut bytes = file.finish();
    // A comment after the end-of-file marker.
    bytes.extend_from_slice(format!("\n% {MADE_BY}\n").as_bytes());
    Ok(bytes)
}
