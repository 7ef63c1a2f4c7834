//! Sorts the objects of a PDF so that their order depends only on the picture. svg2pdf writes fonts and resources in the
//! random order of its hash tables.

use pdf_writer::{Chunk, Primitive, Ref};
use std::collections::HashMap;

/// Body of an object, already encoded.
struct Body(Vec<u8>);

impl Primitive for Body {
    fn write(self, buf: &mut Vec<u8>) {
        buf.extend_from_slice(&self.0);
    }
}

/// Returns the objects in depth-first order of their references from `root`, with sorted dictionary entries.
pub(crate) fn in_order_of_use(chunk: &Chunk, root: Ref) -> Chunk {
    let mut objects: HashMap<Ref, Chunk> = HashMap::new();
    for (id, body) in object_bodies(chunk) {
        let mut object = Chunk::new();
        object.indirect(id).primitive(Body(with_sorted_references(body)));
        objects.insert(id, object);
    }
    let mut ordered = Chunk::with_capacity(chunk.len());
    let mut next = vec![root];
    while let Some(id) = next.pop() {
        let Some(object) = objects.remove(&id) else { continue };
        let mut references = Vec::new();
        // `renumber` calls the function with every reference; the first is the number of the object itself.
        object.renumber(|reference| {
            references.push(reference);
            reference
        });
        ordered.extend(&object);
        next.extend(references.into_iter().skip(1).rev());
    }
    ordered
}

/// Numbers and bodies of the objects, without `N 0 obj` and `endobj`.
fn object_bodies(chunk: &Chunk) -> Vec<(Ref, &[u8])> {
    let ids: Vec<Ref> = chunk.refs().collect();
    let mut rest = chunk.as_bytes();
    let mut bodies = Vec::with_capacity(ids.len());
    for (i, id) in ids.iter().enumerate() {
        let head = format!("{} 0 obj\n", id.get());
        rest = rest.strip_prefix(head.as_bytes()).unwrap_or(rest);
        // The end of an object is found by the header of the next, because a stream may contain `endobj`.
        let end = match ids.get(i + 1) {
            Some(next) => format!("\nendobj\n\n{} 0 obj\n", next.get()),
            None => "\nendobj\n\n".to_owned(),
        };
        let found = match ids.get(i + 1) {
            Some(_) => rest.windows(end.len()).position(|window| window == end.as_bytes()),
            None => rest.len().checked_sub(end.len()),
        };
        let length = found.unwrap_or(rest.len());
        bodies.push((*id, &rest[..length]));
        rest = &rest[(length + "\nendobj\n\n".len()).min(rest.len())..];
    }
    bodies
}

/// Sorts consecutive lines of the form `/NAME N 0 R`, which are entries of one dictionary.
fn with_sorted_references(body: &[u8]) -> Vec<u8> {
    let end = body.windows(STREAM.len()).position(|window| window == STREAM).unwrap_or(body.len());
    let mut lines: Vec<&[u8]> = body[..end].split(|byte| *byte == b'\n').collect();
    for run in lines.chunk_by_mut(|a, b| is_reference(a) && is_reference(b)) {
        run.sort_unstable();
    }
    [&lines.join(&b'\n'), &body[end..]].concat()
}

/// Start of the data of a stream, after its dictionary.
const STREAM: &[u8] = b"\nstream\n";

/// True for a line `/NAME N 0 R`.
fn is_reference(line: &[u8]) -> bool {
    line.trim_ascii_start().starts_with(b"/") && line.ends_with(b" 0 R")
}

#[cfg(test)]
mod tests {
    use super::*;
    use pdf_writer::Name;

    /// A form with two resources and their objects, written in either order.
    fn written(reversed: bool) -> Chunk {
        let numbers = if reversed { [7, 5] } else { [5, 7] };
        let names: [&[u8]; 2] = [b"a", b"b"];
        let mut chunk = Chunk::new();
        let mut order = [0, 1];
        if reversed {
            order.reverse();
        }
        for at in order {
            let data = format!("endobj\n\n{at} 0 obj\n 9 0 R");
            chunk.stream(Ref::new(numbers[at]), data.as_bytes());
        }
        let mut root = chunk.indirect(Ref::new(3)).dict();
        for at in order {
            root.pair(Name(names[at]), Ref::new(numbers[at]));
        }
        drop(root);
        chunk
    }

    #[test]
    fn the_result_does_not_depend_on_the_order_of_writing() {
        let [forward, backward] = [false, true].map(|reversed| {
            let ordered = in_order_of_use(&written(reversed), Ref::new(3));
            assert_eq!(ordered.refs().count(), 3, "no object is lost");
            let (mut ids, mut next) = (HashMap::new(), Ref::new(1));
            ordered.renumber(|old| *ids.entry(old).or_insert_with(|| next.bump())).as_bytes().to_vec()
        });
        assert_ne!(written(false).as_bytes(), written(true).as_bytes());
        assert_eq!(String::from_utf8_lossy(&forward), String::from_utf8_lossy(&backward));
        assert!(forward.ends_with(b"9 0 R\nendstream\nendobj\n\n"));
    }
}
