"""Errors about arguments: every wrong type or number of a public call is an InputError that names the argument."""

from __future__ import annotations

import dataclasses
import functools
import inspect
import os
import re
import sys
import types
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, TypeVar, Union, cast, get_args, get_origin, get_type_hints

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import ArgumentTypeError, PercussError

_Function = TypeVar("_Function", bound=Callable[..., Any])
#: Longest text of a value in a message.
_LONGEST = 60
#: Exceptions of conversions, in Python and in the extension.
_CONVERSIONS = (TypeError, ValueError, OverflowError, AttributeError)
#: Note of the extension about an argument that it cannot convert.
_NOTE = re.compile(r"while processing '(?:r#)?(\w+)'")
#: Types that ArrayLike stands for.
_ARRAY = frozenset(get_args(ArrayLike))
#: Types of arguments by function or class.
_KNOWN: dict[Any, dict[str, Any]] = {}
#: Descriptions of plain types.
_NAMES: dict[Any, str] = {str: "a text", float: "a number", bool: "True or False", type(None): "None", Any: "any value"}


def shown(value: object) -> str:
    """Short text of a value for a message."""
    try:
        text = repr(value)
    except Exception:  # noqa: BLE001 - of a class of the caller
        text = "a value"
    text = text.encode("utf-8", "backslashreplace").decode("utf-8")
    return text if len(text) <= _LONGEST else text[: _LONGEST - 1] + "…"


def _union(hint: Any) -> bool:
    return get_origin(hint) in (Union, types.UnionType)


def _described(hint: Any) -> str:
    """Description of a type for a message."""
    origin, parts = get_origin(hint), get_args(hint)
    if hint is int:
        return "a whole number from 0 to 2^64 − 1"
    if hint in _NAMES:
        return _NAMES[hint]
    if _union(hint):
        return " or ".join(dict.fromkeys(_described(part) for part in parts))
    if origin is Literal:
        return " or ".join(repr(part) for part in parts)
    if origin is not None and issubclass(origin, Sequence) and origin is not tuple:
        return f"a list ({_described(parts[0])} each)"
    if origin is not None and issubclass(origin, Mapping):
        return f"a dict of names ({_described(parts[1])} each)"
    if origin is tuple:
        return "(" + ", ".join(_described(part) for part in parts) + ")"
    if origin is os.PathLike or hint is os.PathLike:
        return "a path"
    return f"a {getattr(hint, '__name__', str(hint))}"


def _is_number(value: Any) -> bool:
    if isinstance(value, (str, bytes)) or getattr(value, "ndim", 0) != 0 or not hasattr(value, "__float__"):
        return False
    try:
        float(value)
    except _CONVERSIONS:
        return False
    return True


def _is_text(value: Any) -> bool:
    if not isinstance(value, str):
        return False
    try:
        value.encode()
    except UnicodeEncodeError:
        return False
    return True


def _fits(value: Any, hint: Any) -> bool:
    """True if a value has a type. Arrays of any kind are left to the conversion of arrays."""
    origin, parts = get_origin(hint), get_args(hint)
    if hint is Any or hint is object:
        return True
    if _union(hint):
        return any(_fits(value, part) for part in parts)
    if hint is None or hint is type(None):
        return value is None
    if origin is Literal:
        return isinstance(value, str) and value in parts
    if hint is float:
        return _is_number(value)
    if hint is int:
        return not isinstance(value, np.ndarray) and hasattr(value, "__index__") and 0 <= value.__index__() < 1 << 64
    if hint is bool:
        return isinstance(value, (bool, np.bool_))
    if hint is str:
        return _is_text(value)
    if origin is tuple:
        # The extension reads the parts, and its messages name them.
        return isinstance(value, (tuple, list))
    if origin is not None and issubclass(origin, Sequence):
        if isinstance(value, np.ndarray):
            return value.ndim > 0 and all(_fits(item, parts[0]) for item in value)
        is_list = isinstance(value, Sequence) and not isinstance(value, (str, bytes))
        return is_list and all(_fits(item, parts[0]) for item in value)
    if origin is not None and issubclass(origin, Mapping):
        is_dict = isinstance(value, Mapping)
        return is_dict and all(_fits(name, parts[0]) and _fits(item, parts[1]) for name, item in value.items())
    expected = origin or hint
    # Protocols and arrays are not classes.
    return not inspect.isclass(expected) or isinstance(value, expected)


def _is_array(hint: Any) -> bool:
    parts = set(get_args(hint))
    return hint == ArrayLike or ArrayLike in parts or (bool(_ARRAY) and _ARRAY <= parts)


def _hints(item: Any) -> dict[str, Any]:
    """Types of the arguments of a function, or of the fields of a class, without those of arrays."""
    if item not in _KNOWN:
        hints = get_type_hints(item).items()
        _KNOWN[item] = {name: hint for name, hint in hints if name != "return" and not _is_array(hint)}
    return _KNOWN[item]


def array_of(value: Any, name: str) -> NDArray[np.float64]:
    """Array of an argument; an InputError if it has no numbers."""
    try:
        return np.asarray(value, dtype=np.float64)
    except _CONVERSIONS as error:
        found = ArgumentTypeError(f"{name} is {shown(value)} ({type(value).__name__}); expected an array of numbers: {error}")
    raise found


def _check(values: Mapping[str, Any], hints: Mapping[str, Any], owner: str = "") -> None:
    for name, value in values.items():
        if name in hints and not _fits(value, hints[name]):
            raise ArgumentTypeError(
                f"{owner}{name} is {shown(value)} ({type(value).__name__}); expected {_described(hints[name])}"
            )


def check_fields(instance: Any) -> None:
    """Refuses fields of a dataclass with another type than declared."""
    fields = {field.name: getattr(instance, field.name) for field in dataclasses.fields(instance)}
    _check(fields, _hints(type(instance)), f"{type(instance).__name__}.")


def _converted(function: Any, error: Exception) -> Exception:
    """The InputError for an error of a conversion; the error itself if its argument is unknown."""
    notes = " ".join(getattr(error, "__notes__", ()))
    named = _NOTE.search(notes)
    message = str(error).encode("utf-8", "backslashreplace").decode("utf-8")
    if named is not None:
        return ArgumentTypeError(f"{named[1]}: {message}")
    # Python 3.10 has no notes.
    if sys.version_info < (3, 11) and not isinstance(error, AttributeError):
        return ArgumentTypeError(f"{getattr(function, '__name__', 'call')}: {message}")
    return error


def checked(function: _Function) -> _Function:
    """Function of Python whose arguments are compared with their annotations before the call."""
    signature = inspect.signature(function)

    @functools.wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        _check(signature.bind(*args, **kwargs).arguments, _hints(function))
        return converting(*args, **kwargs)

    converting = converted(function)
    return cast("_Function", call)


def converted(function: _Function) -> _Function:
    """Function whose errors of conversion are InputErrors. Its cost without an error is that of a call of Python."""

    @functools.wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        try:
            return function(*args, **kwargs)
        except PercussError as error:
            # Notes name the arguments of the extension.
            vars(error).pop("__notes__", None)
            raise
        except _CONVERSIONS as error:
            found = _converted(function, error)
            if found is error:
                raise
        raise found

    return cast("_Function", call)


def convert_all(module: types.ModuleType, names: Sequence[str]) -> None:
    """Converts the functions of a module, and the methods of its classes, in place."""
    for name in names:
        item = getattr(module, name)
        if not inspect.isclass(item):
            setattr(module, name, converted(item))
            continue
        for method, function in list(vars(item).items()):
            if isinstance(function, types.MethodDescriptorType) and not method.startswith("_"):
                own = converted(function)
                # The place where pickle finds it.
                own.__module__ = item.__module__
                setattr(item, method, own)


__all__ = ["array_of", "check_fields", "checked", "convert_all", "converted", "shown"]
