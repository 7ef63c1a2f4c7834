//! Which mechanism an index of a link or a joint belongs to.

use crate::{JointDescription, LinkDescription};

/// A mark of the links and joints that indices number. Mechanisms with the same links and the same joints in the same
/// order have the same mark, whatever their masses and lengths are: an index of a variant means the same link.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Numbering(u32);

impl Numbering {
    /// The mark of these links and joints: a hash (FNV-1a) of the names, and of kind, parent and child of each joint.
    pub fn of(links: &[LinkDescription], joints: &[JointDescription]) -> Self {
        let mut hash: u64 = 0xcbf2_9ce4_8422_2325;
        let mut add = |text: &str| {
            // 0xff is no byte of UTF-8: it separates the texts.
            for byte in text.bytes().chain([0xff]) {
                hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
            }
        };
        links.iter().for_each(|link| add(&link.name));
        for joint in joints {
            [&joint.name, joint.kind.name(), &joint.parent, &joint.child].into_iter().for_each(&mut add);
        }
        Self((hash ^ (hash >> 32)) as u32)
    }
}
