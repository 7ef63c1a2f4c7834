//! Repetition without a loop.

/// Repeats a block for constant indices. A loop would be unrolled as well, but the loops of all the steps inlined into a kernel took
/// half of the time that this library needs to compile.
macro_rules! each {
    ($index:ident in [$($number:literal)+] $block:block) => {$({
        let $index: usize = $number;
        $block
    })+};
}
