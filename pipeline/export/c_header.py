"""A fitted model as one C99 header: its ranges and refusals around the functions of the model."""

import hashlib
import textwrap

from ..models.interface import about
from ..models.parts.box import COLUMNS
from .c_pairs import USAGE, checked_pairs
from .c_text import Body, function, real, renamed
from .caveats import facts
from .inputs import MEANING, Field, Inputs
from .interface import Source, exporter
from .recorded_ranges import WHO_SAYS
from .start_state import start_state, usage

LINE = 110  # characters of a line of the first comment
BAKED = {
    False: "Constant in training",
    True: "Fitted to the string, or constant",
}  # whether dimensions are the string's
CODES = (*COLUMNS, "material")  # the same numbers in every header, whichever fields it has

MATHS = """\
#ifndef TSA_REAL
#define TSA_REAL float /* or double */
#endif
typedef TSA_REAL tsa_real;
#define TSA_R(number) ((tsa_real)(number))

"""
CHECKED = """\
static inline int tsa_held(tsa_real turns, tsa_real *motor_turns)
{
    const tsa_real low = TSA_MOTOR_TURNS_MIN, high = TSA_MOTOR_TURNS_MAX;
    *motor_turns = turns < low ? low : turns > high ? high : turns;
    return turns < low || turns > high ? TSA_HELD : TSA_OK;
}

static inline int tsa_forward(const tsa_state *at, tsa_real motor_turns, tsa_real *displacement_mm)
{
    const int refused = tsa_check(at);
    if (refused != TSA_OK) {
        return refused;
    }
    if (!(motor_turns >= TSA_MOTOR_TURNS_MIN && motor_turns <= TSA_MOTOR_TURNS_MAX)) {
        return TSA_BAD_MOTOR_TURNS;
    }
    *displacement_mm = tsa_raw_forward(at, motor_turns);
    return TSA_OK;
}

static inline int tsa_inverse(const tsa_state *at, tsa_real displacement_mm, tsa_real *motor_turns)
{
    const int refused = tsa_check(at);
    if (refused != TSA_OK) {
        return refused;
    }
    if (!(displacement_mm >= TSA_DISPLACEMENT_MM_MIN && displacement_mm <= TSA_DISPLACEMENT_MM_MAX)) {
        return TSA_BAD_DISPLACEMENT_MM;
    }
    return tsa_held(tsa_raw_inverse(at, displacement_mm), motor_turns);
}

"""


def header(source: Source, name: str) -> str:
    """The whole header's text, its names beginning with `name`_."""
    inputs, c_body = source.inputs, exporter(source.name).body(source)
    parts = [
        _comment(source, c_body),
        "#include <math.h>\n\n",
        MATHS,
        *(_math(function_name) for function_name in ("sqrt", "exp", "log", "atan")),
        _math("pow", "x, tsa_real y", "(double)x, (double)y", "(float)x, (float)y"),
        _codes(),
        _ranges(inputs),
        _state(inputs),
        _check(inputs),
        c_body.code,
        _bytes(c_body),
        CHECKED,
        start_state(source),
        checked_pairs(source),
        c_body.further,
    ]
    return _once(renamed("".join(parts), name), name)


def _once(text: str, name: str) -> str:
    """A header's text as one that may be read twice; another header of the same name beside it is an error."""
    comment, end, code = text.partition(" */\n")
    guard, own = f"{name.upper()}_H", f"{name.upper()}_EXPORT_{hashlib.sha256(text.encode()).hexdigest()[:12].upper()}"
    clash = f"two exports are named {name}, and the first would answer for both: export one again with another --name"
    return (
        f'{comment}{end}#if defined({guard}) && !defined({own})\n#error "{clash}"\n#endif\n'
        f"#ifndef {guard}\n#define {guard}\n#define {own}\n\n{code}#endif /* {guard} */\n"
    )


def _comment(source: Source, c_body: Body) -> str:
    inputs, sentences = source.inputs, facts(source)
    who_says = WHO_SAYS if source.pairs is None else "tsa_recorded"
    baked = [f"{field} {value:.6g}" for field, value in inputs.baked.items() if field not in inputs.unread]
    fitted = about(source.name).each_string_apart
    assumed = [f"{field} is {assumption}." for field, assumption in inputs.assumed.items()]
    lines = [
        f"A twisted string actuator's kinematics, the fitted model {source.name}: twist to contraction and back.",
        *([f"It is of string {source.string} alone."] if source.string else []),
        "C99 (and C++), no dependency but <math.h>, no allocation, no state. Numbers are float; -DTSA_REAL=double.",
        "Every name begins with tsa_. If one program uses two exports, give the second one its own --name.",
        "",
        "    tsa_state state = tsa_start();  then set the fields below",
        "    tsa_forward(&state, motor_turns, &displacement_mm)",
        "    tsa_inverse(&state, displacement_mm, &motor_turns)",
        "",
        "Both return 0 and write the answer, or TSA_BAD_... and write nothing: a field is out of its range or NaN.",
        "tsa_inverse returns TSA_HELD where the contraction lies beyond what the range of twist gives in this state;",
        "the answer is then that end of the range.",
        *(USAGE if source.pairs is not None else ()),
        usage(source),
        *c_body.usage,
        "",
        *_wrapped(sentences.get("older", "")),
        *_wrapped(sentences.get("trained", "")),
        *_wrapped(sentences["strokes"].replace("Beyond,", "Beyond, to TSA_STROKE_MAX,")),
        *_wrapped(sentences.get("errors", "")),
        *_wrapped(f"Zero: {sentences['zero']}"),
        *_wrapped(f"Fit: {sentences['fit']}"),
        *_wrapped(f"{BAKED[fitted]}, and baked in: {', '.join(baked) or 'nothing'}."),
        *_wrapped(sentences.get("unread", "")),
        *_wrapped(sentences.get("recorded", "").replace(WHO_SAYS, who_says)),
        *assumed,
    ]
    return "/*\n" + "".join(f" * {line}".rstrip() + "\n" for line in lines) + " */\n"


def _wrapped(text: str) -> list[str]:
    """A paragraph as lines of a comment."""
    return textwrap.wrap(text, LINE, break_long_words=False, break_on_hyphens=False)


def _math(name: str, arguments: str = "x", double: str = "(double)x", single: str = "(float)x") -> str:
    choice = f"sizeof(tsa_real) > sizeof(float) ? (tsa_real){name}({double}) : (tsa_real){name}f({single})"
    return function("tsa_real", f"tsa_{name}(tsa_real {arguments})", f"return {choice};")


def _codes() -> str:
    codes = ["    TSA_UNRECORDED = -2,", "    TSA_HELD = -1,", "    TSA_OK = 0,"]
    codes += [f"    TSA_BAD_{name.upper()} = {number}," for number, name in enumerate(CODES, start=1)]
    return "enum {\n" + "\n".join(codes).rstrip(",") + "\n};\n\n"


def _ranges(inputs: Inputs) -> str:
    lines = []
    for field in (*inputs.columns("motor_turns"), *inputs.columns("displacement_mm")[:1]):
        for end, value in (("MIN", field.low), ("MAX", field.high)):
            text = str(int(value)) if field.whole else real(value)
            line = f"#define TSA_{field.name.upper()}_{end} {text}\n"
            if field.name == "stroke" and end == "MAX":
                line = f"#ifndef TSA_STROKE_MAX\n{line}#endif\n"
            lines.append(line)
    lines.append(f"#define TSA_STROKE_TRAINED {inputs.last_stroke} /* the last one; beyond, by the law of n */\n")
    lines += [f"#define TSA_MATERIAL_{_word(name)} {number}\n" for number, name in enumerate(inputs.materials)]
    return "".join(lines) + "\n"


def _word(name: str) -> str:
    return "".join(letter if letter.isalnum() else "_" for letter in name).upper()


def _state(inputs: Inputs) -> str:
    def line(field: Field) -> str:
        kind, unit = ("int", "") if field.whole else ("tsa_real", f", {field.unit}")
        return f"    {kind} {field.name}; /* {MEANING[field.name]}{unit} */\n"

    return "typedef struct {\n" + "".join(map(line, inputs.fields)) + "} tsa_state;\n\n"


def _check(inputs: Inputs) -> str:
    lines = []
    for field in inputs.fields:
        name = field.name.upper()
        inside = f"at->{field.name} >= TSA_{name}_MIN && at->{field.name} <= TSA_{name}_MAX"
        if field.name == "direction":
            inside += " && at->direction != 0"
        lines += [f"if (!({inside})) {{", f"    return TSA_BAD_{name};", "}"]
    return function("int", "tsa_check(const tsa_state *at)", *lines, "return TSA_OK;")


def _bytes(c_body: Body) -> str:
    total = " + ".join(f"sizeof {name}" for name in c_body.arrays) or "0u"
    return f"/* Constant data: {c_body.size} bytes, tsa_real being float. */\n#define TSA_CONST_BYTES ({total})\n\n"
