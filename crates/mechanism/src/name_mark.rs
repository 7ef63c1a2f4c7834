//! A mark by which an index of a link or a joint is recognised.

/// Mark of a name. An index carries the mark of its link's or joint's name: it holds in every mechanism that has this name at this
/// index, variants with other masses and lengths included.
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
