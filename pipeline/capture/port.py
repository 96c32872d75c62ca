"""The serial port: opened for this program alone, read in pieces as they come; failures are told in sentences."""

import contextlib
import errno
import time
from types import TracebackType

import serial

from ..ground.errors import BadInput

try:
    import termios
except ImportError:  # no POSIX system
    termios = None  # type: ignore[assignment]

CHUNK = 4096
WAIT_S = 0.05
PATIENCE_S, LOOK_S = 10.0, 0.1  # a port that is not there yet: a rig that starts, a cable that is being plugged in
# pyserial lets termios.error, which is no OSError, and TypeError, from a port closed under it, through
_GONE = (serial.SerialException, OSError, TypeError, *([termios.error] if termios is not None else []))


class Unplugged(Exception):
    """The port went away while it was used."""


class Port:
    """An open port; every error of its driver becomes Unplugged."""

    def __init__(self, name: str, baud: int, patience_s: float = PATIENCE_S) -> None:
        """Open it, or wait for it so long; raises BadInput when it is not there, not ours to open or in use."""
        until_s: float | None = None
        while True:
            try:
                self._serial = serial.Serial(name, baud, timeout=WAIT_S, write_timeout=2.0, exclusive=True)
                return
            except (*_GONE, ValueError) as error:
                if getattr(error, "errno", None) != errno.ENOENT or (until_s and time.monotonic() > until_s):
                    raise BadInput(name, "port", *_why(error)) from None
            if until_s is None:
                until_s = time.monotonic() + patience_s
                print(f"{name}: is not there yet; waiting {patience_s:g} s for it", flush=True)
            time.sleep(LOOK_S)

    def read(self) -> bytes:
        """What has come, at most CHUNK bytes; nothing when nothing comes for WAIT_S."""
        try:
            return self._serial.read(min(max(self._serial.in_waiting, 1), CHUNK))
        except _GONE as error:
            raise Unplugged(str(error)) from None

    def write(self, data: bytes) -> None:
        """Send bytes, and wait until the driver has them."""
        try:
            self._serial.write(data)
            self._serial.flush()
        except _GONE as error:
            raise Unplugged(str(error)) from None

    def __enter__(self) -> "Port":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        with contextlib.suppress(*_GONE):  # if it is gone, that was said
            self._serial.close()


def _why(error: Exception) -> tuple[str, str]:
    number = getattr(error, "errno", None)
    if number == errno.ENOENT:
        return "is not there", "plug the rig in; ls /dev/tty* shows the ports"
    if number == errno.EACCES:
        return "may not be opened by you", "add yourself to the group that owns it, often dialout"
    if number in (errno.EAGAIN, errno.EBUSY) or "exclusively" in str(error):
        return "is in use by another program", "end that one first"
    return f"cannot be opened ({error})", "is it a serial port, and the baud rate one that it knows?"
