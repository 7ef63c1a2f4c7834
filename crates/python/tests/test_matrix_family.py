"""Short run of the matrix family; long run: python tests/matrix_family.py."""

from __future__ import annotations

from matrix_family import family


def test_no_stated_error_is_exceeded() -> None:
    tally = family(1000, 7)
    assert not tally.failures, tally.report()
    assert sum(tally.counts.values()) == 1000
    finite = sum(count for what, count in tally.counts.items() if "finite as finite" in what)
    unclear = sum(count for what, count in tally.counts.items() if "unclear" in what)
    # A family with refused problems proves nothing.
    assert finite > 500 and unclear < 100 and tally.in_batches > 300, tally.report()
    assert all(tally.median(kind) < 1e4 for kind in tally.ratios), tally.report()
