# SPDX-License-Identifier: BSD-3-Clause
"""Inputs, outputs and properties of a filter from its XML in Plugin, as tables in Markdown."""

import xml.etree.ElementTree as ElementTree

_PROPERTIES = ("IntVectorProperty", "DoubleVectorProperty", "StringVectorProperty", "IdTypeVectorProperty")


def tables(file):
    """@param file: path of the XML, with one proxy."""
    proxy = next(ElementTree.parse(file).getroot().iter("ProxyGroup"))[0]
    parts = [_inputs(proxy), _outputs(proxy), _properties(proxy)]
    return "\n".join(part for part in parts if part)


def _inputs(proxy):
    rows = [
        f"| `{one.get('name')}`{' (optional)' if one.find('.//Optional') is not None else ''} | {_text(one)} |"
        for one in proxy.findall("InputProperty")
    ]
    return "\n".join(["| input | what it takes |", "|---|---|", *rows, ""]) if rows else ""


def _outputs(proxy):
    ports = sorted(proxy.findall("OutputPort"), key=lambda port: int(port.get("index")))
    names = ", ".join(f"{port.get('index')} *{port.get('name')}*" for port in ports)
    return f"Outputs: {names}.\n" if len(ports) > 1 else ""


def _properties(proxy):
    rows = [
        f"| `{one.get('name')}`{_advanced(one)} | {_default(one)} | {_text(one)} |"
        for one in proxy
        if one.tag in _PROPERTIES and one.get("name") != "FileName"
    ]
    if not rows:
        return "It has no properties.\n"
    return "\n".join(["| property | default | meaning |", "|---|---|---|", *rows, ""])


def _advanced(one):
    return " (advanced)" if one.get("panel_visibility") == "advanced" else ""


def _text(one):
    documentation = one.find("Documentation")
    text = " ".join((documentation.text or "").split()).replace("|", "\\|")
    entries = [entry.get("text") for entry in one.iter("Entry")]
    if len(entries) > 1 and not all(entry in text for entry in entries):
        text += f" One of {', '.join(entries)}."
    return text


def _default(one):
    value = one.get("default_values", "")
    if one.get("repeat_command") == "1":
        return "none"
    if one.find("ArrayListDomain") is not None:
        return "None"
    if one.find("BooleanDomain") is not None:
        return {"0": "off", "1": "on"}[value]
    for entry in one.iter("Entry"):
        if entry.get("value") == value:
            return entry.get("text")
    return value
