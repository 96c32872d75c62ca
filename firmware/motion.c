#include "motion.h"

#include <stdlib.h>

#include "board.h"
#include "config.h"
#include "program.h"

#define TOP (TOP_TURNS * STEPS_PER_TURN)
#define SLOWEST 100 /* steps/s, at which any stepper starts and stops */
#define TURN ((int64_t)MOTOR_COUNTS_PER_TURN * STEPS_PER_TURN)

static enum { STILL, HOMING, RESTING, WINDING, HOLDING, UNWINDING, FOLLOWING } phase;
static uint16_t stroke;
static uint32_t ticks; /* since the phase began */
static int32_t from, target;
static int32_t fastest; /* 1/16 steps/s */
static uint16_t leg; /* of the program */
static bool winds; /* a stroke of the program is under way */
static int32_t speed; /* 1/16 steps/s: a sample's change of speed is less than a step/s */
static int32_t ramped; /* steps that it took to get that fast, so to stop again */

static void enter(int next)
{
    phase = next;
    ticks = 0;
}

static void go(int next, int32_t to)
{
    from = board_steps();
    target = to;
    speed = ramped = 0;
    enter(next);
}

/* One sample's worth of acceleration or braking; true when the motor is there. */
static bool arrived(void)
{
    int32_t now = board_steps();
    int32_t left = labs(target - now);
    if (left == 0)
        return true;
    if (left <= ramped) {
        speed -= FASTER;
    } else if (speed < fastest) {
        speed += FASTER;
        ramped = labs(now - from);
    }
    if (speed > fastest)
        speed = fastest;
    if (speed < SLOWEST * 16)
        speed = SLOWEST * 16;
    board_drive(target, (uint16_t)(speed / 16));
    return false;
}

/* Whether the encoder is not where the steps should have turned it, by more than a quarter turn. */
static bool stalled(int32_t motor_counts)
{
    int64_t apart = (int64_t)motor_counts * STEPS_PER_TURN - (int64_t)board_steps() * MOTOR_COUNTS_PER_TURN;
    return apart > TURN / 4 || apart < -TURN / 4;
}

void motion_begin(void)
{
    stroke = 0;
    fastest = STEPS_PER_S * 16;
    go(HOMING, 0); /* a run that was stopped has left the string twisted */
}

/* On to the leg; its speed is rounded up, and the time that is left at its end is waited for. */
static void enter_leg(void)
{
    if (leg == program_legs())
        return;
    const struct leg *next = program_at(leg);
    go(FOLLOWING, steps_of(next->milliturns));
    fastest = cruise_of(target - from, next->ms) + 16;
}

void motion_follow(void)
{
    stroke = leg = 0;
    winds = false;
    enter_leg();
}

static enum news follow(void)
{
    if (leg == program_legs()) {
        motion_halt();
        return FINISHED;
    }
    bool there = arrived();
    if (ticks == 1 && target > from && !winds) {
        winds = true;
        stroke++;
        return STROKE_STARTS;
    }
    if (!there || ticks < TICKS(program_at(leg)->ms))
        return NOTHING;
    bool ended = winds && target < from;
    leg++;
    enter_leg();
    if (!ended)
        return NOTHING;
    winds = false;
    return STROKE_ENDS;
}

void motion_halt(void)
{
    phase = STILL;
    board_drive(board_steps(), 0);
}

uint16_t motion_stroke(void)
{
    return stroke;
}

enum news motion_tick(int32_t motor_counts)
{
    if (phase == STILL)
        return NOTHING;
    if (stalled(motor_counts)) {
        motion_halt();
        return STALLED;
    }
    ticks++;
    switch (phase) {
    case HOMING:
        if (arrived())
            enter(RESTING);
        return NOTHING;
    case RESTING:
        if (ticks < TICKS(REST_MS))
            return NOTHING;
        if (stroke == STROKES) {
            motion_halt();
            return FINISHED;
        }
        stroke++;
        go(WINDING, TOP);
        return STROKE_STARTS;
    case WINDING:
        if (arrived())
            enter(HOLDING);
        return NOTHING;
    case HOLDING:
        if (ticks >= TICKS(HOLD_MS))
            go(UNWINDING, 0);
        return NOTHING;
    case UNWINDING:
        if (!arrived())
            return NOTHING;
        enter(RESTING);
        return STROKE_ENDS;
    case FOLLOWING:
        return follow();
    default:
        return NOTHING;
    }
}
