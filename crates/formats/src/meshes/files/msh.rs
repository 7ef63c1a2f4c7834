//! Reader of MSH, MuJoCo's binary format: the counts of vertices, normals, texture coordinates and faces (32-bit integers), then their
//! values in single precision, and three vertex numbers for each face. Source: MuJoCo 4.0, XML reference, `mesh/file`.

use super::triangles::{Triangles, check_triangle_count};

/// Bytes of a number, and of the four counts at the beginning.
const NUMBER_SIZE: usize = 4;
const HEADER_SIZE: usize = 4 * NUMBER_SIZE;

/// Triangles of an MSH file.
pub(super) fn read_msh(bytes: &[u8]) -> Result<Triangles, String> {
    let integer = |at: usize| -> Option<i32> {
        Some(i32::from_le_bytes(bytes.get(at..at.checked_add(NUMBER_SIZE)?)?.try_into().ok()?))
    };
    let count = |number: usize| {
        let value =
            integer(number * NUMBER_SIZE).ok_or_else(|| format!("{} bytes are no MSH", bytes.len()))?;
        usize::try_from(value).map_err(|_| format!("a count is {value}; a number of at least 0 is expected"))
    };
    let (vertices, normals, textures, faces) = (count(0)?, count(1)?, count(2)?, count(3)?);
    check_triangle_count(faces)?;
    let numbers = 3 * (vertices as u128 + normals as u128 + faces as u128) + 2 * textures as u128;
    let expected = HEADER_SIZE as u128 + NUMBER_SIZE as u128 * numbers;
    if bytes.len() as u128 != expected {
        return Err(format!("it announces {expected} bytes and has {}; was it cut off?", bytes.len()));
    }
    let vertex = |index: i32| -> Result<[f64; 3], String> {
        let known = usize::try_from(index).ok().filter(|index| *index < vertices);
        let index =
            known.ok_or_else(|| format!("a face names vertex {index} of {vertices} (the first is 0)"))?;
        let at = HEADER_SIZE + 3 * NUMBER_SIZE * index;
        Ok(std::array::from_fn(|axis| {
            let bits = integer(at + NUMBER_SIZE * axis).unwrap_or_default();
            f64::from(f32::from_bits(bits.cast_unsigned()))
        }))
    };
    let first = HEADER_SIZE + NUMBER_SIZE * (3 * vertices + 3 * normals + 2 * textures);
    let face = |number: usize| {
        let corner = |k: usize| vertex(integer(first + NUMBER_SIZE * (3 * number + k)).unwrap_or(-1));
        Ok([corner(0)?, corner(1)?, corner(2)?])
    };
    (0..faces).map(face).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// File with four vertices and the given faces.
    fn file(faces: &[[i32; 3]]) -> Vec<u8> {
        let counts = [4, 0, 1, faces.len() as i32];
        let numbers = [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.5, 0.1, 0.2];
        let integers = |values: &[i32]| values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>();
        let values: Vec<u8> = numbers.iter().flat_map(|v| v.to_le_bytes()).collect();
        [integers(&counts), values, integers(faces.as_flattened())].concat()
    }

    #[test]
    fn faces_name_vertices() {
        let triangles = read_msh(&file(&[[0, 1, 2], [3, 2, 1]])).unwrap();
        assert_eq!(triangles[1], [[0.0, 0.0, 0.5], [0.0, 2.0, 0.0], [1.0, 0.0, 0.0]]);
    }

    #[test]
    fn bad_files_are_refused() {
        let good = file(&[[0, 1, 2]]);
        assert!(read_msh(&good[..good.len() - 1]).unwrap_err().contains("cut off"));
        assert!(read_msh(&file(&[[0, 1, 4]])).unwrap_err().contains("vertex 4 of 4"));
        assert!(read_msh(&file(&[[0, 1, -1]])).unwrap_err().contains("vertex -1"));
        assert!(read_msh(&[255; 16]).unwrap_err().contains("-1"));
        assert!(read_msh(&[0; 3]).unwrap_err().contains("no MSH"));
        let huge = [i32::MAX.to_le_bytes(); 4].concat();
        assert!(read_msh(&huge).is_err());
    }
}
