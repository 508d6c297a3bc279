# SPDX-License-Identifier: BSD-3-Clause
"""Mouse, keyboard and eyes in ParaView's window, for Utilities/walk.sh: runs inside ParaView.

Qt says where a widget is; the click itself is one of the X server's (xdotool), so that a widget that is hidden, disabled
or behind another is not reached, as a user would not reach it.
"""

import importlib
import os
import subprocess
import time
import traceback

with open("/proc/self/maps", encoding="utf-8") as maps:
    qt = "PyQt6" if "libQt6Core" in maps.read() else "PyQt5"  # that of ParaView: both in a process do not go
try:
    QtCore, QtWidgets = (importlib.import_module(f"{qt}.{name}") for name in ("QtCore", "QtWidgets"))
except ImportError:
    os.write(1, f"{qt} is not installed (Debian: python3-{qt.lower()})\n".encode())
    os._exit(77)

OUTPUT = os.environ["HEXSWEEP_WALK_OUTPUT"]
PATIENCE = float(os.environ.get("HEXSWEEP_WALK_PATIENCE", "60"))  # seconds for one step


class Stumbled(Exception):
    """A user would not come further."""


def xdotool(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True, timeout=30)


def say(text):
    os.write(1, f"walk: {text}\n".encode())  # what is printed is shown in Output Messages


def look(name):
    """Keeps what is on the screen."""
    screen = QtWidgets.QApplication.primaryScreen()
    screen.grabWindow(0).save(os.path.join(OUTPUT, name + ".png"))
    say(name + ".png")


def window():
    return next(w for w in QtWidgets.QApplication.topLevelWidgets() if isinstance(w, QtWidgets.QMainWindow))


def visible(kind, test=lambda widget: True):
    """All widgets that are seen, by the name of their C++ class or one that it is derived from."""
    return [w for w in QtWidgets.QApplication.allWidgets() if w.isVisible() and w.inherits(kind) and test(w)]


def one(kind, test=lambda widget: True, what=""):
    found = visible(kind, test)
    if not found:
        raise Stumbled(f"no {what or kind} is seen")
    return found[0]


def plain(text):
    return text.replace("&", "").replace("…", "...").rstrip(". ")


def button(text, kind="QAbstractButton"):
    return one(kind, lambda w: plain(w.text()) == text, f'button "{text}"')


def place(widget, x=0.5, y=0.5):
    """Where a point of a widget, in parts of its size, is on the screen."""
    corner = widget.mapToGlobal(QtCore.QPoint(0, 0))
    return corner.x() + int(x * widget.width()), corner.y() + int(y * widget.height())


def click(widget, x=0.5, y=0.5):
    if not widget.isEnabled():
        raise Stumbled(f"{widget.metaObject().className()} {widget.objectName()} cannot be pressed")
    xdotool("mousemove", *place(widget, x, y), "sleep", 0.1, "click", 1)


def drag(widget, begin, end):
    """A rubber band, in parts of the widget's size."""
    xdotool("mousemove", *place(widget, *begin), "sleep", 0.2, "mousedown", 1, "sleep", 0.2, "mousemove", *place(widget, *end),
            "sleep", 0.2, "mouseup", 1)


def click_action(menu, text):
    """An entry of a menu or of the menu bar that is open."""
    for action in menu.actions():
        if plain(action.text()) == text:
            if not action.isEnabled():
                raise Stumbled(f'"{text}" cannot be chosen')
            centre = menu.mapToGlobal(menu.actionGeometry(action).center())
            xdotool("mousemove", centre.x(), centre.y(), "sleep", 0.1, "click", 1)
            return
    raise Stumbled(f'there is no "{text}" in the menu')


def choose(*path):
    """Steps through the menus: choose("File", "Open")."""
    menu = window().menuBar()
    for i, text in enumerate(path):
        click_action(menu, text)
        if i + 1 < len(path):
            yield lambda wanted=text: any(plain(w.title()) == wanted for w in visible("QMenu"))
            yield 0.5
            menu = one("QMenu", lambda w, wanted=text: plain(w.title()) == wanted)


def type_into(widget, text):
    click(widget)
    yield 0.3
    xdotool("key", "ctrl+a")
    xdotool("type", "--delay", 5, text)
    yield 0.5


def choose_item(box, text):
    """An entry of a combo box, by the mouse."""
    click(box)
    yield lambda: box.view().isVisible()
    yield 0.5
    row = next((i for i in range(box.count()) if box.itemText(i) == text), None)
    if row is None:
        raise Stumbled(f'the list has no "{text}", but {[box.itemText(i) for i in range(box.count())]}')
    view = box.view()
    where = view.visualRect(box.model().index(row, box.modelColumn(), box.rootModelIndex())).center()
    where = view.viewport().mapToGlobal(where)
    xdotool("mousemove", where.x(), where.y(), "sleep", 0.1, "click", 1)
    yield 0.5


def messages():
    """The lines of Output Messages."""
    lines = []
    for widget in QtWidgets.QApplication.allWidgets():
        if widget.inherits("pqOutputWidget"):
            for text in widget.findChildren(QtWidgets.QPlainTextEdit) + widget.findChildren(QtWidgets.QTextEdit):
                lines += text.toPlainText().splitlines()
    return [line for line in lines if line.strip()]


def quiet():
    """Nothing is complained about."""
    yield 0.3
    told = messages()
    if told:
        look("messages")
        raise Stumbled("Output Messages: " + " | ".join(told))


def view_widget():
    return one("pqQVTKWidget", what="view")


def reveal(widget):
    """Turns the mouse's wheel until a widget of a panel is seen whole."""
    area = widget.parent()
    while not area.inherits("QScrollArea"):
        area = area.parent()
    for _ in range(60):
        if widget.visibleRegion().boundingRect() == widget.rect():
            return
        xdotool("mousemove", *place(area.viewport(), 0.02, 0.5), "click", 5)
        yield 0.15
    raise Stumbled(f"{widget.text()} cannot be scrolled to")


def welcome(picture=""):
    """What ParaView greets a new user with."""
    yield lambda: visible("QMainWindow") and visible("pqWelcomeDialog")
    # There may be no window manager that makes it fill the screen.
    window().setGeometry(QtWidgets.QApplication.primaryScreen().geometry())
    yield 1.0
    if picture:
        look(picture)
    dialog = one("pqWelcomeDialog")
    click(next(w for w in visible("QAbstractButton") if w.window() is dialog and plain(w.text()) == "Close"))
    yield lambda: not visible("pqWelcomeDialog")
    yield 1.0


def type_file(path, picture=""):
    """Names the file in ParaView's file dialog."""
    yield lambda: visible("pqFileDialog")
    yield 1.0
    dialog = one("pqFileDialog")
    lines = visible("QLineEdit", lambda w: w.window() is dialog)
    line = max(lines, key=lambda w: place(w)[1])  # below that for favourites
    yield from type_into(line, path)
    if picture:
        look(picture)
    xdotool("key", "Return")
    yield lambda: not visible("pqFileDialog")
    yield 0.7


def apply():
    click(button("Apply"))
    yield lambda: not button("Apply").isEnabled()
    yield 0.7


def colour_by(array):
    """By the list in the tool bar; that of the panel may be scrolled away."""
    box = one("QComboBox", lambda w: w.objectName() == "Variables" and not w.visibleRegion().isEmpty(), "list of arrays")
    yield from choose_item(box, array)
    yield 1.0


def isometric():
    click(one("QToolButton", lambda w: w.defaultAction() and "isometric" in w.defaultAction().text().lower(), "isometric view"))
    yield 0.5


def pick(where):
    """Selects cells on the face at a point of the view, in parts of its size."""
    view = view_widget()
    click(view, 0.02, 0.02)  # the keys are for the view
    yield 0.5
    xdotool("key", "s")
    yield 0.5
    drag(view, where, (where[0] + 0.02, where[1] + 0.02))
    yield 1.5


def copy_selection():
    """Presses the upper one of the buttons Copy Active Selection, that of the source."""
    buttons = visible("QAbstractButton", lambda w: plain(w.text()) == "Copy Active Selection")
    if not buttons:
        raise Stumbled("no button Copy Active Selection is seen")
    upper = min(buttons, key=lambda w: place(w)[1])
    yield from reveal(upper)
    click(upper)
    yield 1.0


class Walk(QtCore.QObject):
    """Runs steps one after the other while ParaView's own events go on. A step is a generator that yields what it waits for:
    seconds, or a function that becomes true."""

    def __init__(self, steps):
        super().__init__()
        self.stack, self.wish, self.since, self.name = [steps], 0.0, time.time(), ""
        self.timer = QtCore.QTimer()
        self.timer.setInterval(100)
        self.timer.timeout.connect(self.tick)
        self.timer.start()
        self.busy = False

    def tick(self):
        if self.busy:  # an event loop inside of a step
            return
        self.busy = True
        try:
            self.go()
        except Exception:  # noqa: BLE001 whatever it is, it ends the walk
            look("stumbled")
            say(traceback.format_exc())
            os._exit(1)
        finally:
            self.busy = False

    def go(self):
        waited = time.time() - self.since
        if callable(self.wish):
            if not self.wish():
                if waited > PATIENCE:
                    raise Stumbled(f"waited {waited:.0f} s in vain, line {self.stack[-1].gi_frame.f_lineno}")
                return
        elif waited < self.wish:
            return
        self.wish, self.since = next(self.stack[-1], None), time.time()
        if self.wish is None:
            self.stack.pop()
            self.wish = 0.0
            if not self.stack:
                self.timer.stop()


def end():
    """Ends ParaView, and all went well."""
    os._exit(0)


def start(steps):
    global walk  # else it is collected when the script ends
    walk = Walk(steps)
