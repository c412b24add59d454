# SPDX-License-Identifier: GPL-3.0-or-later
"""Prints the chapter doc/python_reference.md from the docstrings: python3 python/tests/make_reference.py > doc/python_reference.md"""

import enum
import inspect
import re

from numpydoc.docscrape import NumpyDocString, Parameter

import spherical_parameterization as sp

FUNCTIONS = [name for name in sp.__all__ if inspect.isfunction(inspect.unwrap(getattr(sp, name)))]
CLASSES = [name for name in sp.__all__ if inspect.isclass(getattr(sp, name)) and name != "OpenCLDevice"]
COLLECTION = [f"collection.{name}" for name in ("map", "read", "map_file", "signature_file")]


def find(name: str) -> object:
    found: object = sp
    for part in name.split("."):
        found = getattr(found, part)
    return found


def item(parameter: Parameter) -> str:
    head = " : ".join(f"`{part}`" for part in parameter[:2] if part)
    return "\n  ".join([f"- {head}" + "." * bool(parameter.desc), *filter(None, parameter.desc)])


def entry(name: str) -> str:
    thing = find(name)
    text = inspect.getdoc(thing) or ""
    if inspect.isclass(thing):
        has_list = "__dataclass_fields__" in vars(thing) or issubclass(thing, enum.Enum)
        found = re.findall(r"^    (\w+)(?:: | = )(.*?)(?:  #: (.*))?$", inspect.getsource(thing), re.MULTILINE) if has_list else []
        fields = [f"{field} : {kind}" + f"\n    {comment}" * bool(comment) for field, kind, comment in found]
        if fields and "Parameters\n" not in text and "Attributes\n" not in text:
            text += "\n\nAttributes\n----------\n" + "\n".join(fields)
    doc = NumpyDocString(text)
    parts = [f"### sp.{name}"]
    if inspect.isroutine(inspect.unwrap(thing)):  # type: ignore[arg-type]
        signature = inspect.signature(thing)  # type: ignore[arg-type]
        arguments = [p.replace(annotation=p.empty) for p in signature.parameters.values()]
        call = signature.replace(parameters=arguments, return_annotation=signature.empty)
        parts.append(f"```python\nsp.{name}{call}\n```")
    parts.append("\n".join(doc["Summary"] + [""] * bool(doc["Extended Summary"]) + doc["Extended Summary"]))
    for title in ("Parameters", "Attributes", "Returns", "Yields", "Raises", "Warns"):
        if doc[title]:
            parts += [f"**{title}**", "\n".join(map(item, doc[title]))]
    for title in ("Notes", "References"):
        parts += ["\n".join(doc[title])] if doc[title] else []
    if doc["Examples"]:
        parts.append("```python\n" + "\n".join(doc["Examples"]) + "\n```")
    return "\n\n".join(parts) + "\n"


def methods(name: str) -> list[str]:
    members = {m: f for m, f in vars(find(name)).items() if not m.startswith("_") and inspect.getdoc(f)}
    return [f"{name}.{m}" for m, f in members.items() if inspect.isfunction(f) or isinstance(f, property)]


def page() -> str:
    parts = ["# Python: reference\n", "Written by `python/tests/make_reference.py` from the docstrings.\n"]
    sections = {"Functions": FUNCTIONS, "Collections": COLLECTION, "Classes": CLASSES}
    for title, names in sections.items():
        parts.append(f"## {title}\n")
        for name in names:
            parts.append(entry(name))
            parts += map(entry, methods(name))
    return "\n".join(parts).rstrip()


if __name__ == "__main__":
    print(page())
