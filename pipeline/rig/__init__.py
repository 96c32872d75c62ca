"""The synthetic rig: motion, a string stepped in time, sensors, and a device that speaks the wire protocol."""
