//! Partition of indices into disjoint sets.

/// Disjoint sets of the indices 0..n.
pub(crate) struct Partition {
    parent: Vec<usize>,
}

impl Partition {
    /// Partition with every index in a set of its own.
    pub fn new(n: usize) -> Self {
        Self { parent: (0..n).collect() }
    }

    /// Representative of the set of `i`: its smallest index.
    pub fn root(&mut self, mut i: usize) -> usize {
        while self.parent[i] != i {
            self.parent[i] = self.parent[self.parent[i]];
            i = self.parent[i];
        }
        i
    }

    /// Joins the sets of `a` and `b`.
    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b)] = a.min(b);
    }
}
