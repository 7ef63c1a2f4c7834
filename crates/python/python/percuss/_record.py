"""Base of the records: dicts whose keys are attributes."""

from __future__ import annotations

import html
import json
from collections.abc import Callable, Iterable, Mapping
from typing import TYPE_CHECKING, Any, TypeVar, get_args, get_origin, get_type_hints

_R = TypeVar("_R", bound="Record")
_Convert = Callable[[Any], Any]
#: Units for a moment about an axis, by the units for a contact point.
_UNITS_OF_MOMENT = {"kg": "kg m²", "N s": "N m s", "m/s": "rad/s", "N": "N m"}
#: Keys that repr shows, with their units, by type.
_ANSWERS: Mapping[str, Mapping[str, str]] = {
    "DampingReport": {"damping": "", "dissipation": "", "achieved_restitution": "", "peak_force": "N"},
    "MassReport": {"effective_mass": "kg", "effective_mass_error": "kg", "status": ""},
    "ReflectedReport": {"drivers": "", "reflected_inertia": "", "reflected_over": ""},
    "FrictionThresholdsRecord": {"sticking": "", "jamming": ""},
    "Explanation": {"effective_mass": "", "links": ""},
    "ToleranceReport": {"effective_mass": "", "root_sum_square": "", "worst_case": ""},
    "ContactListReport": {"contacts": ""},
    "SweepReport": {"link": "", "rows": ""},
    "SweepRow": {"row": "", "effective_mass": "", "status": ""},
    "ComparisonReport": {"designs": "", "rows": ""},
    "DesignRecord": {"name": "", "effective_mass": "kg", "difference_percent": "%"},
    "KinematicsReport": {"variable": "", "columns": "", "rows": ""},
    "ImpactReport": {"impulse": "N s", "energy_loss": "J", "closing_speed": "m/s"},
    "ExtremesReport": {"least.effective_mass": "kg", "most.effective_mass": "kg"},
    "ExtremeRecord": {"effective_mass": "", "status": ""},
    "MapRecord": {"links": ""},
    "PointMapReport": {"link": "", "principal": "", "directions": ""},
    "SafeSpeedReport": {"reflected.speed": "m/s", "standard.speed": "m/s", "limited_by": ""},
    "CheckReport": {"name": "", "total_mass": "kg", "degrees_of_freedom": "", "links": "", "diagnostics": ""},
}
#: Keys that describe the report, not the result.
_HEADING = ("schema", "percuss", "inputs")


class Record(dict[str, Any]):
    """Part of a report: the dict that the command prints with ``--format json``. Keys are attributes too."""

    @classmethod
    def of(cls: type[_R], values: Mapping[str, Any]) -> _R:
        """Record of a plain dict; dicts in it become records of their types."""
        convert = _conversions(cls)
        return cls({key: convert[key](value) if key in convert and value is not None else value for key, value in values.items()})

    if not TYPE_CHECKING:
        # Hidden from type checkers, which use the annotations of the class.
        def __getattr__(self, key: str) -> Any:
            try:
                return self[key]
            except KeyError:
                if key in _keys(type(self)):
                    return None
                raise AttributeError(f"the {type(self).__name__} has no {key!r}; it has {', '.join(self)}") from None

    def __dir__(self) -> Iterable[str]:
        return sorted({*super().__dir__(), *(key for key in self if key.isidentifier())})

    def to_dict(self) -> dict[str, Any]:
        """The record as plain dicts and lists."""
        return {key: _plain(value) for key, value in self.items()}

    def to_json(self, *, indent: int | None = None) -> str:
        """The record as JSON."""
        return json.dumps(self, indent=indent)

    def _facts(self) -> list[tuple[str, str]]:
        facts: list[tuple[str, str]] = []
        for key, value in self.items():
            if isinstance(value, bool) or value is None:
                continue
            if isinstance(value, float):
                facts.append((key, f"{value:.10g}"))
            elif isinstance(value, (int, str)):
                facts.append((key, str(value)))
            elif isinstance(value, list) and key in ("rows", "links", "diagnostics"):
                facts.append((key, f"{len(value)}"))
        return facts

    def __repr__(self) -> str:
        units = _UNITS_OF_MOMENT if _is_moment(self) else {}
        keys = next((_ANSWERS[kind.__name__] for kind in type(self).__mro__ if kind.__name__ in _ANSWERS), {})
        answer = [f"{key}: {_shown(self, key)}{unit and ' ' + units.get(unit, unit)}" for key, unit in keys.items()]
        if not answer:
            answer = [f"{key}: {value}" for key, value in self._facts() if key not in _HEADING]
        return f"<{type(self).__name__} {', '.join(answer)}>"

    def _repr_html_(self) -> str:
        rows = "".join(
            f"<tr><th style='text-align:left'>{html.escape(key)}</th><td>{html.escape(value)}</td></tr>"
            for key, value in self._facts()
        )
        return f"<table>{rows}</table>"


class AnyRecord(Record):
    """Report whose type depends on the question of a study: type checkers accept every key."""

    if TYPE_CHECKING:

        def __getattr__(self, key: str) -> Any: ...


def _at(record: Record, path: str) -> Any:
    """Value at a path of keys; None if it does not exist."""
    value: Any = record
    for key in path.split("."):
        value = value.get(key) if isinstance(value, dict) else None
    return value


def _is_moment(record: Record) -> bool:
    """True if the contact of the report is a moment about an axis."""
    keys = ("is_moment", "contact.is_moment", "mass.contact.is_moment")
    return any(_at(record, key) is True for key in keys) or _at(record, "mass_unit") == "kg·m²"


def _shown(record: Record, path: str) -> str:
    """Text of the value at a path of keys: a number, the length of a list, or text."""
    value = _at(record, path)
    if isinstance(value, float):
        return f"{value:.7g}"
    return str(len(value)) if isinstance(value, list) else str(value)


def _plain(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _plain(inner) for key, inner in value.items()}
    return [_plain(inner) for inner in value] if isinstance(value, list) else value


#: Conversions of each type; computed when the first record of a type is made.
_CONVERSIONS: dict[type[Record], Mapping[str, _Convert]] = {}


def _keys(record: type[Record]) -> frozenset[str]:
    """Keys that the type of a record states."""
    return frozenset(key for key in get_type_hints(record) if not key.startswith("_"))


def _conversions(record: type[Record]) -> Mapping[str, _Convert]:
    """Conversion of each key that contains records."""
    if record not in _CONVERSIONS:
        hints = get_type_hints(record)
        found = ((key, _conversion(hints[key])) for key in _keys(record))
        _CONVERSIONS[record] = {key: convert for key, convert in found if convert is not None}
    return _CONVERSIONS[record]


def _conversion(hint: Any) -> _Convert | None:
    """Conversion of a type; None if it contains no record."""
    if get_origin(hint) is None and isinstance(hint, type) and issubclass(hint, Record):
        return hint.of
    reports = [part for part in get_args(hint) if isinstance(part, type) and issubclass(part, Record)]
    if len(reports) > 1:
        # Of several records, the one with the most similar keys.
        return lambda value: min(reports, key=lambda report: len(_keys(report) ^ value.keys())).of(value)
    inner = [convert for convert in map(_conversion, get_args(hint)) if convert is not None]
    return _of_parts(get_origin(hint), inner[0]) if inner else None


def _of_parts(origin: Any, convert: _Convert) -> _Convert:
    """Conversion of a list, a dict, or an optional value with records in it."""
    if origin is list:
        return lambda values: [convert(value) for value in values]
    if origin is dict:
        return lambda values: {key: convert(value) for key, value in values.items()}
    # Optional.
    return lambda value: None if value is None else convert(value)
