// Nothing: its target makes the precompiled header of the window's tests.
