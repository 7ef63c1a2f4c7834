"""Kinds of findings about a row, as in the remarks of a sweep or of a batch of matrices."""

from __future__ import annotations

import enum


class RemarkFlags(enum.IntFlag):
    """Kinds of findings about a row; the bits equal those of PERCUSS_REMARK_… in the C interface.

    percuss.RemarkFlags(int(swept.remarks[3])) lists the kinds of a row; Sweep.findings and MatrixBatch.findings have a
    text for each kind.

        >>> percuss.RemarkFlags(4096).name
    """

    NEARLY_IMMOVABLE = 1
    MASSLESS_MOTIONS = 1 << 1
    MASSLESS_TO_ROUNDING = 1 << 2
    UNDETERMINED_MOTION = 1 << 3
    UNCLEAR_RANK = 1 << 4
    INDEFINITE = 1 << 5
    SINGULAR_POSE = 1 << 6
    OTHER_ASSEMBLY = 1 << 7
    DRAWN_OPEN = 1 << 8
    INEXACT_LOOPS = 1 << 9
    DRIVER_OFF_ZERO = 1 << 10
    OFF_TARGET = 1 << 11
    OUTSIDE_LIMITS = 1 << 12
    WEAKLY_CONSTRAINED = 1 << 13
    UNCLEAR_MOBILITY = 1 << 14
    BASE_NOT_GIVEN = 1 << 15
    NOT_FINITE = 1 << 16
    NOT_UNIT_QUATERNION = 1 << 17
    OPEN_LOOPS = 1 << 18
    NO_ANSWER = 1 << 19
    UNCERTAIN_MASS = 1 << 20
    UNKNOWN_ERROR = 1 << 21
    OPEN_GAP = 1 << 22
    MANY_TURNS = 1 << 23
