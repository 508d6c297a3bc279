# SPDX-License-Identifier: BSD-3-Clause
"""Says what is not in order in the panels that ParaView makes of Plugin/*.xml.

    python3 check_panels.py SOURCE_DIR

Where a filter has groups of properties each property is in one of them; lists and selections, which ParaView shows
without a name, are in a group of their own. Each filter of the menu has an icon of its own, and each icon is a resource.
"""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path


def group_problems(name, proxy):
    groups = [[one.get("name") for one in group.findall("Property")] for group in proxy.findall("PropertyGroup")]
    shown = {
        one.get("name"): one
        for one in proxy
        if one.tag.endswith("VectorProperty") and one.get("panel_visibility") != "never" or is_selection(one)
    }
    members = [one for group in groups for one in group]
    if not groups:
        return [f"{name}: {one} is in no group" for one in shown if is_nameless(shown[one])]
    problems = [f"{name}: the groups have {one}, which is no property" for one in members if one not in shown]
    problems += [f"{name}: {one} is in {members.count(one)} groups" for one in shown if members.count(one) != 1]
    return problems + [
        f"{name}: {one} is in a group with others"
        for group in groups for one in group if len(group) > 1 and one in shown and is_nameless(shown[one])
    ]


def is_selection(one):
    return one.find("Hints/SelectionInput") is not None


def is_nameless(one):
    """Lists and selections, which ParaView shows without a name."""
    return one.get("repeat_command") == "1" or is_selection(one)


def icon_problems(icons, resources, files):
    """@param icons: by filter. @param resources: files of the .qrc. @param files: those that are there."""
    problems = [f"{name}: no icon" for name, icon in icons.items() if not icon]
    named = [icon.rpartition("/")[2] for icon in icons.values() if icon]
    problems += [f"{icon} is the icon of {named.count(icon)} filters" for icon in sorted(set(named)) if named.count(icon) > 1]
    problems += [f"{icon} is no resource" for icon in named if icon not in resources]
    return problems + [f"{one} is not there, or not in the .qrc" for one in sorted(resources ^ files)]


def problems_of(root):
    problems, icons = [], {}
    for file in sorted((root / "Plugin").glob("*.xml")):
        tree = ElementTree.parse(file).getroot()
        problems += group_problems(file.stem, next(tree.iter("ProxyGroup"))[0])
        for filters in tree.iter("ParaViewFilters"):
            icons.update((one.get("name"), one.get("icon")) for one in filters.iter("Proxy"))
    folder = root / "Plugin" / "Resources"
    resources = {one.text for one in ElementTree.parse(folder / "HexSweep.qrc").getroot().iter("file")}
    return problems + icon_problems(icons, resources, {one.name for one in folder.glob("*.svg")})


if __name__ == "__main__":
    found = problems_of(Path(sys.argv[1]))
    print("\n".join(found), file=sys.stderr)
    sys.exit(1 if found else 0)
