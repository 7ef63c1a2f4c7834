//! Mark of a name, stored in every index of a link or joint to detect indices of another mechanism.

/// Hash of a name. An index of a link or joint carries the hash of its name. The index is valid in every mechanism that
/// has the same name at the same position, for example in variants with other masses and lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct NameMark(u32);

impl NameMark {
    /// Hash (FNV-1a) of the name.
    pub fn of(name: &str) -> Self {
        let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        let hash = name.bytes().fold(0xcbf2_9ce4_8422_2325, step);
        Self((hash ^ (hash >> 32)) as u32)
    }
}
