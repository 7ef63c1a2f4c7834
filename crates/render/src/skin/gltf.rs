//! glTF 2.0 (Khronos, ISO/IEC 12113): one mesh per piece, with vertex colours and the value as an extra attribute.

use super::colour::Scale;
use super::{Skin, SkinPiece};
use base64::Engine;
use serde_json::{Value, json};

/// Component types and buffer targets of the format.
const FLOAT: u32 = 5126;
const UNSIGNED_BYTE: u32 = 5121;
const ARRAY_BUFFER: u32 = 34962;

impl Skin {
    /// Returns the skin as a binary glTF file (.glb). Colours are the attribute `COLOR_0`. The value is the
    /// attribute `_NAME`, with the skin's `property` in capitals as NAME (`_VALUE` if empty); −1 if there is no
    /// value. The root node rotates the z axis of the skin to the y axis of glTF.
    pub fn to_glb(&self) -> Vec<u8> {
        let (mut document, mut binary) = self.document();
        while binary.len() % 4 != 0 {
            binary.push(0);
        }
        document["buffers"] = json!([{ "byteLength": binary.len() }]);
        let mut text = document.to_string().into_bytes();
        while text.len() % 4 != 0 {
            text.push(b' ');
        }
        let mut file = Vec::with_capacity(28 + text.len() + binary.len());
        let length = |n: usize| (n as u32).to_le_bytes();
        file.extend(b"glTF");
        file.extend(length(2));
        file.extend(length(28 + text.len() + binary.len()));
        file.extend(length(text.len()));
        file.extend(b"JSON");
        file.extend(text);
        file.extend(length(binary.len()));
        file.extend(b"BIN\0");
        file.extend(binary);
        file
    }

    /// Returns the skin as one text file (.gltf) with embedded data.
    pub fn to_gltf(&self) -> String {
        let (mut document, binary) = self.document();
        let text = base64::engine::general_purpose::STANDARD.encode(&binary);
        let uri = format!("data:application/octet-stream;base64,{text}");
        document["buffers"] = json!([{ "byteLength": binary.len(), "uri": uri }]);
        document.to_string()
    }

    /// JSON of the glTF and its binary buffer.
    fn document(&self) -> (Value, Vec<u8>) {
        let mut parts = Parts { scale: Scale::of(self), ..Parts::default() };
        let name = if self.property.is_empty() { "VALUE".into() } else { self.property.to_uppercase() };
        let (mut meshes, mut nodes) = (Vec::new(), Vec::new());
        for piece in self.pieces.iter().filter(|piece| !piece.facets.is_empty()) {
            let attributes = parts.add(piece, &format!("_{name}"));
            nodes.push(json!({ "name": piece.name, "mesh": meshes.len() }));
            let primitive = json!({ "attributes": attributes, "material": 0, "mode": 4 });
            meshes.push(json!({ "name": piece.name, "primitives": [primitive] }));
        }
        let children: Vec<usize> = (0..nodes.len()).collect();
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let mut root = json!({ "name": self.title, "rotation": [-half, 0.0, 0.0, half] });
        if !children.is_empty() {
            root["children"] = json!(children);
        }
        nodes.push(root);
        let mut document = json!({
            "asset": { "version": "2.0", "generator": "percuss" },
            "scene": 0,
            "scenes": [{ "nodes": [nodes.len() - 1] }],
            "nodes": nodes,
            "materials": [{
                "pbrMetallicRoughness": { "metallicFactor": 0.0, "roughnessFactor": 1.0 },
                "doubleSided": true
            }],
            "extras": { "quantity": self.quantity, "least": parts.scale.low, "greatest": parts.scale.high }
        });
        // glTF does not allow empty lists.
        for (key, list) in [("meshes", meshes), ("accessors", parts.accessors), ("bufferViews", parts.views)]
        {
            if !list.is_empty() {
                document[key] = json!(list);
            }
        }
        (document, parts.binary)
    }
}

#[derive(Default)]
struct Parts {
    scale: Scale,
    binary: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Parts {
    /// Appends the vertices of a piece to the buffer and returns its mesh.
    fn add(&mut self, piece: &SkinPiece, name: &str) -> Value {
        let facets = &piece.facets;
        let count = 3 * facets.len();
        let (mut low, mut high) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        let start = self.binary.len();
        for corner in facets.iter().flat_map(|facet| facet.corners) {
            for (axis, x) in corner.into_iter().enumerate() {
                let x = x as f32;
                (low[axis], high[axis]) = (low[axis].min(x), high[axis].max(x));
                self.binary.extend(x.to_le_bytes());
            }
        }
        let bounds = json!({ "min": low, "max": high });
        let position = self.accessor(start, count, FLOAT, "VEC3", bounds);
        let start = self.binary.len();
        for facet in facets {
            for x in [facet.normal; 3].into_iter().flatten() {
                self.binary.extend((x as f32).to_le_bytes());
            }
        }
        let normal = self.accessor(start, count, FLOAT, "VEC3", json!({}));
        let start = self.binary.len();
        for facet in facets {
            let c = self.scale.colour(facet.value);
            for _ in 0..3 {
                self.binary.extend([srgb_to_linear(c.0), srgb_to_linear(c.1), srgb_to_linear(c.2), 255]);
            }
        }
        let colour = self.accessor(start, count, UNSIGNED_BYTE, "VEC4", json!({ "normalized": true }));
        let start = self.binary.len();
        for facet in facets {
            for _ in 0..3 {
                self.binary.extend((facet.value.unwrap_or(-1.0) as f32).to_le_bytes());
            }
        }
        let value = self.accessor(start, count, FLOAT, "SCALAR", json!({}));
        json!({ "POSITION": position, "NORMAL": normal, "COLOR_0": colour, name: value })
    }

    /// Adds an accessor with a buffer view and returns its index; `extra` holds further keys.
    fn accessor(&mut self, start: usize, count: usize, component: u32, kind: &str, extra: Value) -> usize {
        let view = json!({
            "buffer": 0,
            "byteOffset": start,
            "byteLength": self.binary.len() - start,
            "target": ARRAY_BUFFER
        });
        let mut accessor = json!({
            "bufferView": self.views.len(),
            "componentType": component,
            "count": count,
            "type": kind
        });
        if let (Some(accessor), Value::Object(extra)) = (accessor.as_object_mut(), extra) {
            accessor.extend(extra);
        }
        self.views.push(view);
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }
}

/// Converts a colour channel from sRGB to linear (IEC 61966-2-1), as glTF vertex colours require.
fn srgb_to_linear(c: u8) -> u8 {
    let x = f64::from(c) / 255.0;
    let y = if x <= 0.04045 { x / 12.92 } else { ((x + 0.055) / 1.055).powf(2.4) };
    (255.0 * y).round() as u8
}
