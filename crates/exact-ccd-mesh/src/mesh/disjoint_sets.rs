//! Sets of vertices that grow together.

/// Disjoint sets of vertices, each a tree: union by size, and paths that are halved as they are walked.
///
/// Any sequence of m unions and searches takes O((m + n) α(n)) steps, α the inverse of Ackermann's
/// function: R. E. Tarjan and J. van Leeuwen, *Worst-case Analysis of Set Union Algorithms*, 1984.
#[derive(Debug)]
pub(crate) struct DisjointSets {
    /// The vertex above each vertex in its tree, itself for a root.
    above: Vec<u32>,
    /// The number of vertices below each root, itself included.
    size: Vec<u32>,
    /// The number of vertices that searches have passed.
    #[cfg(test)]
    steps: usize,
}

impl DisjointSets {
    /// One set for each vertex.
    pub(crate) fn new(count: usize) -> Self {
        Self {
            above: (0..count).map(|vertex| vertex as u32).collect(),
            size: vec![1; count],
            #[cfg(test)]
            steps: 0,
        }
    }

    /// The vertex that stands for the set of a vertex.
    pub(crate) fn root(&mut self, mut vertex: u32) -> u32 {
        loop {
            let above = self.above[vertex as usize];
            if above == vertex {
                return vertex;
            }
            #[cfg(test)]
            {
                self.steps += 1;
            }
            self.above[vertex as usize] = self.above[above as usize];
            vertex = above;
        }
    }

    /// Unites the sets of two vertices.
    pub(crate) fn unite(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        if a == b {
            return;
        }
        let (less, more) = if self.size[a as usize] < self.size[b as usize] {
            (a, b)
        } else {
            (b, a)
        };
        self.above[less as usize] = more;
        // At most the number of vertices.
        self.size[more as usize] = self.size[more as usize].saturating_add(self.size[less as usize]);
    }
}

#[cfg(test)]
mod tests {
    use super::DisjointSets;

    const COUNT: u32 = 1 << 16;

    /// The number of steps per vertex of some unions, each followed by a search for a vertex that may be
    /// deep.
    fn steps(unions: impl Iterator<Item = ([u32; 2], u32)>) -> f64 {
        let mut sets = DisjointSets::new(COUNT as usize);
        let mut count = COUNT;
        for ([a, b], deep) in unions {
            sets.unite(a, b);
            sets.root(deep);
            count += 1;
        }
        let root = sets.root(0);
        assert!((0..COUNT).all(|vertex| sets.root(vertex) == root));
        sets.steps as f64 / f64::from(count)
    }

    #[test]
    fn the_number_of_steps_is_nearly_linear() {
        let last = COUNT - 1;
        let rising = (0..last).map(|vertex| ([vertex, vertex + 1], 0));
        let falling = (0..last).rev().map(|vertex| ([vertex, vertex + 1], last));
        let halves = (0..16).flat_map(|bit| {
            let size = 1 << bit;
            (0..COUNT)
                .step_by(2 * size)
                .map(move |first| ([first, first + size as u32], first + 2 * size as u32 - 1))
        });
        let mut random = fastrand::Rng::with_seed(81);
        let shuffled: Vec<_> = {
            let mut vertices: Vec<u32> = (0..COUNT).collect();
            random.shuffle(&mut vertices);
            vertices
                .windows(2)
                .map(|pair| ([pair[0], pair[1]], pair[0] / 2))
                .collect()
        };
        for per_vertex in [
            steps(rising),
            steps(falling),
            steps(halves),
            steps(shuffled.into_iter()),
        ] {
            assert!(per_vertex < 5.0, "{per_vertex}");
        }
    }
}
