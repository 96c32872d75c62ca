"""What the person at the rig is told of a recording that has ended: what came, what mends it, and what comes next."""

from pathlib import Path
from typing import TYPE_CHECKING

from ..ground.errors import BadInput
from ..ground.names import SYNTHETIC_DEVICE
from ..ground.words.counts import counted
from ..run.capture_json import CaptureJson
from ..run.ended_words import ABORTED, cause, ending
from ..run.folder import capture_info, read_run
from .printed.clock_words import tell_clock
from .printed.fitting_columns import check_channels, unusable_columns
from .printed.lines_to_csv import Finished
from .printed.lines_words import clock_question, tell_lines
from .refused_run import reader_of, refusal, tell_refused

if TYPE_CHECKING:
    from ..string.jumps_beside import Reader

GAPS_TOLD = 5  # of frames; all stand in capture.json


def tell(info: CaptureJson, folder: Path, is_recovered: bool = False) -> bool:
    """Say what was recorded, and what is missing for the run to be used; whether what was recorded can be used.

    That nobody has described the run yet is no fault of its recording, and a mend to be made in run.yaml is none.
    Printed lines that are recovered, so that they can be used now, are judged by that, which is said too.
    """
    reader, refused, all_named = None, None, False
    judged = is_recovered and "lines" in info
    is_fault = info["exit_status"] == "fault"
    if "lines" in info:
        usable = not unusable_columns(folder)
        if usable and not info["lines"]["time_backward"]:  # of a clock that falls back it is asked first
            reader = reader_of(folder)
            refused = refusal(folder, reader)
        if refused:
            all_named = tell_refused(refused, folder, info)
        tell_lines(info, folder, usable, all_named)
    else:
        tell_frames(info, folder)
    early = info["exit_status"] == ABORTED  # then the first line has said what ended it
    ended = f"ended by {cause(info)}" if cause(info) and not early else None
    if ended or info["fault"]:
        print(f"{folder}: {'; '.join(filter(None, (ended, info['fault'])))}; what had come is kept")
    if early:
        print(f"{folder}: the rig was not done; what had come is kept, and its whole strokes are used like any run's")
    described = False
    try:
        run = read_run(folder)
        described = True
        if "lines" in info:
            check_channels(run, folder)
            tell_clock(run, folder, info)
    except BadInput as error:
        if "lines" in info and info["lines"]["time_backward"]:
            print(f"{folder}: {clock_question(info, folder)}")
        print(f"{error} Until then nothing can use this run.")
        return not (described or (judged and is_fault))
    can_be_used = refused is None
    if refused is None:
        tell_beginning(folder, reader)  # None of frames: their rig begins its motion when the recording does
        reader = reader or reader_of(folder)
        if judged and not is_fault and not refusal(folder, reader):
            print(f"{folder}: it can be used: run.yaml reads it by these columns")
        can_be_used = tell_of_its_string(folder, info, reader, judged)
    return can_be_used or not judged


def tell_beginning(folder: Path, reader: "Reader | None") -> None:
    """Say of printed lines that can be used whether the rig was amid a stroke when the first of them came."""
    from .amid_stroke import began_amid  # it needs pandas, for which no rig should wait

    if reader and (sentence := began_amid(reader(folder))):
        print(f"{folder}: warning: {sentence}")


def tell_of_its_string(
    folder: Path, info: CaptureJson, reader: "Reader | None" = None, is_settled: bool = False
) -> bool:
    """Say whether the zero moved since the string's run before, and what comes next; whether the run can be used.

    `is_settled`: what can be used of a recording that a fault ended decides the exit status, and not the fault.
    """
    from ..string.jumps_beside import Beside, advice_on  # it needs pandas, for which no rig should wait
    from ..string.next_steps import next_steps
    from .use_after_fault import strokes_of_use, strokes_unwound

    reader = reader or reader_of(folder)
    beside = Beside(reader=reader)
    for sentence in advice_on(folder, beside):
        print(f"{folder}: {sentence}")
    if not info["samples"]["received"]:
        return False
    hello = info.get("hello")
    try:
        if hello and info["exit_status"] == "complete":
            whole = hello["strokes"]
        elif info["exit_status"] != "fault":
            whole = strokes_unwound(folder, reader)
        else:
            whole = strokes_of_use(folder, reader, "" if is_settled else "; the exit status 1 tells of the fault")
    except BadInput as error:
        tell_refused(error, folder, info)
        return False
    anew = hello is not None and hello["device"] == SYNTHETIC_DEVICE and "program" not in hello
    print("\n".join(next_steps(folder, whole, anew, beside)))
    return True


def tell_finished(folder: Path, finished: Finished) -> bool:
    """Say of a finished run of printed lines what comes next; whether it can be used as run.yaml describes it now.

    Raises `finished` for a run that nobody has described.
    """
    info, reader = capture_info(folder), reader_of(folder)
    if not (folder / "run.yaml").is_file():
        raise finished
    if refusal(folder, reader):
        print(f"{folder}: nothing is to be recovered: it is read by these columns already")
        tell(info, folder)
        return False
    print(f"{folder}: there is nothing to recover: the recording is finished, and run.yaml as it is now reads it")
    return tell_of_its_string(folder, info, reader, is_settled=True)


def tell_frames(info: CaptureJson, folder: Path) -> None:
    """Say how many frames came, and where others were lost."""
    frames, samples = info["frames"], info["samples"]
    print(
        f"{folder}: {ending(info)}, {counted(samples['received'], 'sample')}; frames: {frames['sent']} sent = "
        f"{frames['received']} received + {frames['lost']} lost, {frames['bad']} bad"
    )
    for gap in info["gaps"][:GAPS_TOLD]:
        where = "before the first sample" if gap["after_s"] is None else f"after {gap['after_s']:g} s"
        strokes = ", ".join(map(str, gap["strokes"])) or "none"
        print(
            f"{folder}: {gap['frames']} frame{'s' * (gap['frames'] > 1)} lost {where}; strokes it may touch: {strokes}"
        )
    if len(info["gaps"]) > GAPS_TOLD:
        print(f"{folder}: and in {counted(len(info['gaps']) - GAPS_TOLD, 'more place')}, see capture.json")
    if samples["out_of_order"]:
        often = counted(samples["out_of_order"], "time")
        print(f"{folder}: samples came out of order ({often}); their numbers put them right")
    clock = {"backward": samples["backward_time_stamps"], "repeated": samples["repeated_time_stamps"]}
    if any(clock.values()) and info["exit_status"] != "fault":
        both = " and ".join(f"{times} {word}" for word, times in clock.items() if times)
        stamps = f"{both} time stamp{'s' * (sum(clock.values()) != 1)}"
        print(f"{folder}: the device's clock gave {stamps}, mended when the run is read")
    sent = samples["sent"]
    if sent is not None and not 0 <= sent - samples["received"] <= frames["lost"]:
        print(
            f"{folder}: warning: the device counted {counted(sent, 'sample')}, {samples['received']} can be read, and "
            "lost frames do not explain it: check its firmware against docs/protocol.md"
        )
