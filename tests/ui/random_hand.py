#!/usr/bin/python3
"""A hand at random on a real window: clicks, drags, keys, numbers and files by a seed, on every panel and dialog.

    random_hand.py TALUS FOLDER --seed 1 --seconds 15

The window must not end, hang, print an error of OpenGL or lose undo: at the end everything is undone, and the saved
terrain has the hash that it began with; an autosave that is there must be readable. Acts are printed to FOLDER/acts.json as
they are done; `--acts FILE` does those of a file again, and a failure is repeated with fewer and fewer of them
(`--shrink N` tries), so that the shortest list that still fails stands in FOLDER/shrunk.json.
Widgets are found by the names that `talus --ui-rects` writes. Needs Xvfb and Debian's python3-xlib.
"""
import argparse
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from Xlib import X, XK, display, error
from Xlib.ext import xtest

from ping import await_answer

# Nothing waits longer than this for the window to answer, s. A loaded machine needs more than the two seconds of a person.
PATIENCE_S = float(os.environ.get("TALUS_HAND_PATIENCE_S", "2"))

# What would end the session in an orderly way, change how much undo keeps, go on for a minute, make a terrain that takes
# long, or lead out of the folder that it may write to.
LEFT_ALONE = {"Quit", "undo.memory_mib", "Verify this device", "terrain.nx", "terrain.ny", "Up", "recent folders"}
KEYS = ["space", "period", "f", "F6", "F12", "Tab", "Escape", "bracketleft", "bracketright", "minus", "equal", "Return",
        "ctrl+z", "ctrl+shift+z", "ctrl+y", "ctrl+s", "ctrl+e", "ctrl+o", "ctrl+n", "ctrl+shift+s", "ctrl+a", "Delete", "w", "a",
        "s", "d", "q", "e", "1", "2", "3", "4", "5", "6", "7", "8", "9", "shift+1", "shift+2", "shift+3", "shift+4",
        "shift+5", "Left", "Right", "Up", "Down", "BackSpace", "KP_Enter"]
NUMBERS = ["0", "1", "-1", "0.5", "12", "90", "1e9", "-1e9", "1e-9", "nan", "inf", "abc", "", "1,5", "0x10", "1e400", "33",
           "100", "7"]
SIZES = [(1280, 720), (1024, 768), (640, 480), (590, 400), (420, 300), (200, 160), (1400, 900), (800, 1000)]


class Failure(Exception):
    pass


class Screen:
    """An X server of its own."""

    def __init__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1400x1000x24", "-noreset"],
                                       pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as told:
            self.name = ":" + told.readline().strip()
        self.display = display.Display(self.name)
        self.root = self.display.screen().root
        self.root.change_attributes(event_mask=X.SubstructureNotifyMask)

    def close(self):
        self.display.close()
        self.server.terminate()
        self.server.wait()


class Window:
    """Talus in a window, and the hand on it."""

    def __init__(self, talus, folder, screen, options):
        self.folder, self.screen = folder, screen
        self.rects_file = folder / "rects"
        self.rects_file.unlink(missing_ok=True)
        environment = dict(os.environ, DISPLAY=screen.name, LIBGL_ALWAYS_SOFTWARE="1",
                           XDG_STATE_HOME=str(folder / "state"), XDG_CONFIG_HOME=str(folder / "config"),
                           XDG_CACHE_HOME=str(folder / "cache"))
        self.log_path = folder / "window.log"
        self.log = open(self.log_path, "w")
        self.process = subprocess.Popen([talus, *options, "--ui-rects", "rects"], cwd=folder, env=environment,
                                        stdout=self.log, stderr=self.log)
        self.slowest_s = 0.0
        self.window = self.find()
        self.wait_for(lambda: self.rects(), 60, "the window never drew a panel")

    def find(self):
        end = time.time() + 60
        while time.time() < end:
            self.check_alive()
            for child in self.screen.root.query_tree().children:
                if (child.get_wm_name() or "").endswith("Talus"):
                    return child
            time.sleep(0.05)
        raise Failure("no window appeared")

    def check_alive(self):
        if self.process.poll() is not None:
            raise Failure(f"the window ended with {self.process.returncode}: {self.words()[-600:]}")
        found = re.search(r"OpenGL reports.*|terminate called.*|.*AddressSanitizer.*|.*runtime error:.*", self.words())
        if found:
            raise Failure(f"it printed: {found.group(0)}")

    def words(self):
        self.log.flush()
        return self.log_path.read_text(errors="replace")

    def wait_for(self, condition, seconds, what):
        end = time.time() + seconds
        while not condition():
            self.check_alive()
            if time.time() > end:
                raise Failure(f"{what}; widgets: {sorted(self.rects())}")
            time.sleep(0.02)

    def rects(self):
        try:
            lines = self.rects_file.read_text().splitlines()
        except OSError:
            return {}
        found = {}
        for line in lines:
            left, top, right, bottom, name = line.split(" ", 4)
            found.setdefault(name, (int(left), int(top), int(right), int(bottom)))
        return found

    def size(self):
        geometry = self.window.get_geometry()
        return geometry.width, geometry.height

    def answers(self):
        """Waits until the window has taken in what was done: it answers a ping of the window manager's protocol."""
        seconds = await_answer(self.screen.display, self.window, PATIENCE_S)
        if seconds is None:
            self.check_alive()
            raise Failure(f"the window did not answer for {PATIENCE_S} s")
        self.slowest_s = max(self.slowest_s, seconds)

    # The hand.
    def code(self, key):
        return self.screen.display.keysym_to_keycode(XK.string_to_keysym(key))

    def fake(self, kind, detail=0, **where):
        xtest.fake_input(self.screen.display, kind, detail, **where)
        self.screen.display.flush()

    def move(self, x, y):
        width, height = self.size()
        self.fake(X.MotionNotify, x=max(1, min(int(x), width - 2)), y=max(1, min(int(y), height - 2)))

    def press(self, chord):
        *modifiers, key = chord.split("+")
        names = {"ctrl": "Control_L", "shift": "Shift_L", "alt": "Alt_L"}
        for modifier in modifiers:
            self.fake(X.KeyPress, self.code(names[modifier]))
        self.fake(X.KeyPress, self.code(key))
        time.sleep(0.03)
        self.fake(X.KeyRelease, self.code(key))
        for modifier in reversed(modifiers):
            self.fake(X.KeyRelease, self.code(names[modifier]))

    def click(self, x, y, button=1, modifier=None, times=1):
        self.move(x, y)
        time.sleep(0.06)
        if modifier:
            self.fake(X.KeyPress, self.code(modifier))
        for _ in range(times):
            self.fake(X.ButtonPress, button)
            time.sleep(0.05)
            self.fake(X.ButtonRelease, button)
            time.sleep(0.03)
        if modifier:
            self.fake(X.KeyRelease, self.code(modifier))

    def drag(self, path, button, modifier):
        self.move(*path[0])
        time.sleep(0.06)
        if modifier:
            self.fake(X.KeyPress, self.code(modifier))
        self.fake(X.ButtonPress, button)
        for x, y in path[1:]:
            time.sleep(0.06)
            self.move(x, y)
        time.sleep(0.06)
        self.fake(X.ButtonRelease, button)
        if modifier:
            self.fake(X.KeyRelease, self.code(modifier))

    def type(self, text):
        special = {"/": "slash", ".": "period", "-": "minus", "_": "underscore", ",": "comma", " ": "space"}
        for letter in text:
            name = special.get(letter, letter)
            shifted = letter.isupper() or letter == "_"
            if shifted:
                self.fake(X.KeyPress, self.code("Shift_L"))
            self.fake(X.KeyPress, self.code(name))
            self.fake(X.KeyRelease, self.code(name))
            if shifted:
                self.fake(X.KeyRelease, self.code("Shift_L"))
            time.sleep(0.005)

    def middle(self, name):
        rect = self.rects().get(name)
        return rect and ((rect[0] + rect[2]) / 2, (rect[1] + rect[3]) / 2)

    def is_seen(self, name):
        """Whether the widget lies in the window, and not behind the edge of its panel."""
        rect = self.rects().get(name)
        width, height = self.size()
        return rect and rect[0] >= 0 and rect[1] >= 0 and rect[2] <= width and rect[3] <= height

    def await_rest(self, name):
        """Waits until the widget stays where it is: a dialog takes its place within its first frames."""
        before = None
        for _ in range(50):
            self.answers()
            self.answers()
            time.sleep(0.1)
            now = self.middle(name)
            if now and now == before:
                return
            before = now
        raise Failure(f"'{name}' does not come to rest")

    def busy(self):
        return "Cancel work" in self.rects()

    def click_on(self, name, button=1, modifier=None, times=1):
        place = self.middle(name)
        if place and self.is_seen(name):
            self.click(*place, button, modifier, times)
            return True
        return False

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.log.close()


def choose(chance, window, files):
    """The next act, as a list that `do` does again."""
    widgets = [name for name in window.rects() if name not in LEFT_ALONE and window.is_seen(name)]
    kind = chance.random()
    modifier = chance.choice([None, None, None, "Control_L", "Shift_L"])
    if "file name" in widgets and kind < 0.5:
        return ["file", str(chance.choice(files)), chance.choice(["Return", "Return", "Escape"])]
    if "export path" in widgets and kind < 0.3:
        ending = chance.choice([".tif", ".png", ".r16", ".obj", ".glb", ".exr", ".jpg", "", "/no/such/folder/a.tif", ".raw"])
        return ["export", ("" if ending.startswith("/") else "out-%d" % chance.randrange(4)) + ending]
    if widgets and kind < 0.42:
        return ["click", chance.choice(widgets), chance.choice([1, 1, 1, 1, 3, 2]), modifier if chance.random() < 0.1 else None,
                chance.choice([1, 1, 1, 2])]
    numbers = [name for name in widgets if "." in name and "=" not in name]
    if numbers and kind < 0.55:
        return ["number", chance.choice(numbers), chance.choice(NUMBERS), chance.choice(["Return", "Return", "Escape", "Tab"])]
    if numbers and kind < 0.62:
        return ["slide", chance.choice(numbers), chance.randint(-200, 200), chance.choice([1, 1, 1, 3])]
    if kind < 0.80:
        path = [[round(chance.random(), 3), round(chance.random(), 3)] for _ in range(chance.randint(2, 5))]
        return ["picture", path, chance.choice([1, 1, 1, 3, 2]), modifier]
    if kind < 0.93:
        return ["key", chance.choice(KEYS)]
    if kind < 0.96:
        return ["wheel", round(chance.random(), 3), round(chance.random(), 3), chance.choice([4, 5]), chance.randint(1, 6)]
    if kind < 0.98:
        return ["edge", chance.choice(["left", "right"]), chance.randint(-250, 250)]
    return ["resize", *chance.choice(SIZES)]


def do(act, window):
    kind, *rest = act
    width, height = window.size()
    if kind == "click":
        name, button, modifier, times = rest
        window.click_on(name, button, modifier, times)
    elif kind == "number":
        name, text, end = rest
        if window.click_on(name, 1, "Control_L"):
            time.sleep(0.1)
            window.press("ctrl+a")
            window.type(text)
            window.press(end)
    elif kind == "slide":
        name, way, button = rest
        place = window.middle(name)
        if place and window.is_seen(name):
            window.drag([place, (place[0] + way / 2, place[1]), (place[0] + way, place[1] + 3)], button, None)
    elif kind == "picture":
        path, button, modifier = rest
        # Between the panels where there is room; dialogs are clicked by name alone, so that no folder beside is written to.
        if "file name" in window.rects():
            return
        window.drag([(width * (0.2 + 0.5 * x), height * (0.06 + 0.88 * y)) for x, y in path], button, modifier)
    elif kind == "key":
        window.press(rest[0])
    elif kind == "wheel":
        x, y, button, times = rest
        window.click(width * x, height * y, button, None, times)
    elif kind == "file":
        if window.click_on("file name"):
            window.press("ctrl+a")
            window.type(rest[0])
            window.press(rest[1])
    elif kind == "export":
        if window.click_on("export path"):
            window.press("ctrl+a")
            window.type(rest[0])
            window.press("Return")
            time.sleep(0.1)
            window.click_on("Write")
    elif kind == "edge":
        # Of the tools on the left, or the panels on the right.
        side, way = rest
        place = window.rects().get("Redo" if side == "left" else "Simulation")
        if place:
            at = (place[2] + 8, height / 2) if side == "left" else (place[0] - 8, height / 2)
            window.drag([at, (at[0] + way / 2, at[1]), (at[0] + way, at[1])], 1, None)
    elif kind == "resize":
        window.window.configure(width=rest[0], height=rest[1])
        window.screen.display.flush()


def run(command, folder):
    return subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True, timeout=120)


def make_files(talus, folder):
    """Good and bad files to open."""
    files = folder / "files"
    files.mkdir()
    small = ["--size", "61x47", "--ticks", "0", "--preset", "slopes"]
    run([talus, "run", *small, "--out", files / "good.exr", "--out", files / "good.tif"], folder)
    run([talus, "run", "--size", "64x64", "--preset", "slopes", "--ticks", "3", "--set", "water.rain_mm_per_h=500", "--out",
         files / "wet.exr"], folder)
    for ending in [".png", ".r16", ".r32", ".exr"]:
        run([talus, "convert", files / "good.tif", files / ("heights" + ending)], folder)
    run([talus, "tile", "--generate", "mountains,8200x150", files / "tiles.tif"], folder)
    good = (files / "good.exr").read_bytes()
    (files / "half.exr").write_bytes(good[: len(good) // 2])
    (files / "half.tif").write_bytes((files / "good.tif").read_bytes()[:200])
    (files / "empty.tif").write_bytes(b"")
    (files / "text.png").write_text("this is no picture")
    (files / "nan.r32").write_bytes(b"\0\0\xc0\x7f" * 33 * 33)
    (files / "odd.r16").write_bytes(b"x" * 999)
    (files / "folder.tif").mkdir()
    # A PNG that claims 60000 x 60000 pixels.
    (files / "huge.png").write_bytes(bytes.fromhex("89504e470d0a1a0a0000000d494844520000ea600000ea6010000000006f1b7e5b"))
    return sorted(files.iterdir()) + [files / "missing.tif", Path("valley"), Path("again.exr"), Path("wrong.jpg")]


def unfold(window):
    """Brings back panels that were folded to a button."""
    for name in ("unfold Panels", "unfold Tools"):
        if window.click_on(name):
            window.wait_for(lambda: name not in window.rects(), 10 + PATIENCE_S, f"'{name}' brings nothing back")


def undo_everything(window, talus, folder):
    """Ends dialogs and play, takes back every act, saves, and compares with what the scene began with."""
    window.window.configure(width=1280, height=720)
    window.screen.display.flush()
    # A dialog can follow another: for a frame, between the one for files and the one for imports, there is none. So none
    # must be there twice, with a pause between.
    without = 0
    for _ in range(120):
        window.answers()
        time.sleep(0.2)
        window.answers()
        rects = window.rects()
        if window.busy():
            # Verifying takes minutes under a sanitizer; nothing is saved before it ends or is given up.
            window.click_on("Cancel work")
            without = 0
        elif {"file name", "export path", "import spacing", "Cancel", "Cancel import", "Cancel export", "Cancel new terrain", "Close"} & set(rects):
            window.press("Escape")
            without = 0
        else:
            without += 1
        if without == 2:
            break
    unfold(window)
    if "Profiler" not in window.rects():
        window.press("Escape")
        # A field that is typed into has the keys until the frame after the one that ends it.
        window.answers()
        window.answers()
        window.press("Tab")
        window.wait_for(lambda: "Profiler" in window.rects(), 10 + PATIENCE_S, "panels do not come back")
    unfold(window)
    if not {"Play", "Pause"} & set(window.rects()):
        # Terrain in tiles is looked at: nothing was done to it.
        return
    window.move(640, 400)
    window.press("Escape")
    time.sleep(0.3)
    begun = re.findall(r"begun with hash ([0-9a-f]{16})", window.words())[-1]
    # As often as there may be acts; what is left to undo stands in the menu.
    for _ in range(400):
        window.press("ctrl+z")
        window.answers()
        window.click_on("Edit")
        # Only that menu has this line: without it, what is not there yet would be taken for nothing left.
        window.wait_for(lambda: "Start the scene over" in window.rects(), 20, "the menu Edit did not open")
        left = [name for name in window.rects() if name == "Undo" or name.startswith("Undo ")]
        window.press("Escape")
        window.wait_for(lambda: "Start the scene over" not in window.rects(), 20,
                        "Escape did not close the menu Edit")
        # The button on the left is called Undo too; the menu's line has the act's name while there is one.
        if not [name for name in left if name.startswith("Undo ")]:
            break
    end = folder / "end.exr"
    window.move(640, 400)
    window.press("ctrl+shift+s")
    window.wait_for(lambda: "file name" in window.rects(), 10, "the dialog to save did not open")
    window.await_rest("file name")
    window.click_on("file name")
    # Typed before the click has reached the field, the path would be lost, and another file be written.
    window.answers()
    window.answers()
    window.press("ctrl+a")
    window.type(str(end))
    window.press("Return")
    window.wait_for(end.exists, 30, "undone, it could not be saved")
    time.sleep(0.3)
    window.answers()
    found = run([talus, "info", "--json", end], folder).stdout
    now = re.search(r'"hash": "([0-9a-f]*)"', found)
    if not now or now.group(1) != begun:
        raise Failure(f"undo does not lead back: begun with {begun}, now {now and now.group(1)}")


def attempt(talus, folder, seed, seconds, acts):
    """Does acts, those given or others until the time is up. Returns what was done, and why it failed, if it did."""
    root = folder
    shutil.rmtree(root, ignore_errors=True)
    # So deep that a hand which climbs in a dialog for files, and saves there, saves within the folder that it was given.
    folder = root.joinpath(*["deep"] * 8)
    folder.mkdir(parents=True)
    files = make_files(talus, folder)
    chance = random.Random(seed)
    begins = [["--preset", "slopes", "--size", "97x81"], [str(files[0].parent / "wet.exr")], [],
              [str(files[0].parent / "good.tif"), "--set", "water.rain_mm_per_h=200"],
              [str(files[0].parent / "tiles.tif")]]
    options = [*begins[seed % len(begins)], "--set", "autosave.interval_s=2", "--window-size", "1280x720"]
    if "--size" in options:
        at = options.index("--size")
        del options[at:at + 2]
        options[:2] = [str(files[0].parent / "good.exr")]
    screen = Screen()
    done = []
    window = None
    try:
        window = Window(talus, folder, screen, options)
        end = time.time() + seconds
        while (len(done) < len(acts)) if acts is not None else (time.time() < end):
            act = acts[len(done)] if acts is not None else choose(chance, window, files)
            done.append(act)
            (root / "acts.json").write_text(json.dumps(done))
            do(act, window)
            window.answers()
            window.check_alive()
        kept = sorted(folder.glob("state/talus/sessions/*/autosave.exr"))
        for autosave in kept:
            copy = folder / "autosave-copy.exr"
            shutil.copy(autosave, copy)
            if run([talus, "info", copy], folder).returncode != 0:
                raise Failure("the autosave cannot be read")
        undo_everything(window, talus, folder)
        return done, None, window.slowest_s
    except Failure as failure:
        return done, str(failure), 0.0
    except (error.XError, error.ConnectionClosedError, subprocess.TimeoutExpired) as failure:
        # A window that ended answers no question of the display's.
        ended = window and window.process.poll()
        return done, f"the window ended with {ended}: {window.words()[-600:]}" if ended is not None else str(failure), 0.0
    finally:
        if window:
            window.close()
        screen.close()


def kind_of(failure):
    """What two failures have in common that are the same: their first words."""
    return failure and failure[:20]


def shrink(talus, folder, seed, acts, failure, tries):
    """Leaves out what the failure does not need: halves, quarters, …, single acts."""
    size = max(1, len(acts) // 2)
    while tries > 0:
        shorter = None
        for first in range(0, len(acts), size):
            if tries == 0:
                break
            tries -= 1
            fewer = acts[:first] + acts[first + size:]
            if kind_of(attempt(talus, folder, seed, 0, fewer)[1]) == kind_of(failure):
                shorter = fewer
                break
        if shorter is not None:
            acts = shorter
            size = max(1, min(size, len(acts) // 2))
        elif size == 1:
            break
        else:
            size = max(1, size // 2)
    return acts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("talus")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=15)
    parser.add_argument("--acts", type=Path)
    parser.add_argument("--shrink", type=int, default=0, metavar="TRIES")
    given = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    talus = str(Path(given.talus).resolve())
    folder = given.folder.resolve()
    acts = json.loads(given.acts.read_text()) if given.acts else None
    done, failure, slowest_s = attempt(talus, folder, given.seed, given.seconds, acts)
    if not failure:
        print(f"seed {given.seed}: {len(done)} acts, the slowest answer after {slowest_s:.2f} s")
        return
    print(f"FAILED: seed {given.seed}, act {len(done)}: {failure}")
    for act in done[-12:]:
        print("   ", json.dumps(act))
    if given.shrink:
        shrunk = shrink(talus, folder / "shrinking", given.seed, done, failure, given.shrink)
        (folder / "shrunk.json").write_text(json.dumps(shrunk))
        print(f"the shortest list that fails has {len(shrunk)} acts:")
        for act in shrunk:
            print("   ", json.dumps(act))
    sys.exit(1)


if __name__ == "__main__":
    main()
