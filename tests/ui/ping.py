#!/usr/bin/python3
"""Waits until a window has taken in what was done: it answers a ping of the window manager's protocol.

    ping.py WINDOW

reads numbers of frames, one a line, and prints "drawn" for each as soon as the window has drawn as many, or has nothing left
to draw. Needs Debian's python3-xlib.
"""
import sys
import time

from Xlib import X, display, protocol


def await_answer(screen, window, seconds):
    """Returns the seconds that the answer took, or None where none came. Its screen's root must have been asked for
    SubstructureNotify."""
    while screen.pending_events():
        screen.next_event()
    protocols = screen.intern_atom("WM_PROTOCOLS")
    begin = time.time()
    window.send_event(protocol.event.ClientMessage(window=window, client_type=protocols,
                                                   data=(32, [screen.intern_atom("_NET_WM_PING"), X.CurrentTime, window.id, 0, 0])))
    screen.flush()
    while time.time() - begin < seconds:
        while screen.pending_events():
            event = screen.next_event()
            if event.type == X.ClientMessage and event.client_type == protocols:
                return time.time() - begin
        time.sleep(0.005)
    return None


def main():
    screen = display.Display()
    screen.screen().root.change_attributes(event_mask=X.SubstructureNotifyMask)
    window = screen.create_resource_object("window", int(sys.argv[1]))
    for line in sys.stdin:
        # It answers where a frame begins: the first answer tells that it knows of what was done, each further one of a frame.
        for _ in range(int(line) + 1):
            if await_answer(screen, window, 60) is None:
                sys.exit("no answer within 60 s")
        print("drawn", flush=True)


if __name__ == "__main__":
    main()
