"""What the nonlinear parameters mean that several mechanisms have. One of a single mechanism stands in its own file."""

MEANINGS = {  # as `Mechanism.meanings` says them
    "at_s": "when it happens, from the start of the recording; below 0: a little in every stroke",
    "critical_turns": "the {motion} from which on it acts",
    "fastest_s": "the shortest time constant that the recording could show",
    "slowest_s": "the longest time constant that the recording could show",
    "from_load": "the load at which it does nothing",
    "from_turns": "where the travel begins",
    "span_turns": "the range of the {motion}, {scale}",
    "half_waves": "by how many half waves over the recording it may wander",
    "load_power": "to which power the load counts in the work: 0 not at all, 1 in proportion",
    "loaded": "1 means: the load varied, so that parts that grow with it were tried, and 0: it did not",
    "later_runs": (
        "0 means: each later run goes on from the one before, a minute after it; 1: it begins as the first one did; "
        "2: the {string} had been loaded for long before it"
    ),
    "sign": "1 means: more, as thicker or longer, with what it follows; -1 means: less",
    "slow_turns_per_s": "the speed below which what slides begins to stick",
    "softness_turns": "how softly it begins",
    "steepest": "the largest tan(helix angle) of the recording, {scale}",
    "whole_s": "the length of the recording, {scale}",
    "within_s": "in which time it is over; 0: at once",
    "work": "the whole work of the recording, {scale}",
}
