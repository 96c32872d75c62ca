/* The experiment: rest, then so many times wind, hold, unwind, rest. Called once a sample; knows no hardware. */
#ifndef MOTION_H
#define MOTION_H

#include <stdint.h>

#include "config.h"

enum news { NOTHING, STROKE_STARTS, STROKE_ENDS, FINISHED, STALLED };

/* The change of speed in 1/16 steps/s from one sample to the next, and the acceleration in steps/s2 that it makes. */
#define TICKS(ms) ((uint32_t)(ms) * RATE_HZ / 1000)
#define RAMP_TICKS (TICKS(RAMP_MS) > 0 ? TICKS(RAMP_MS) : 1)
#define FASTER ((STEPS_PER_S * 16 / (int32_t)RAMP_TICKS) > 0 ? (STEPS_PER_S * 16 / (int32_t)RAMP_TICKS) : 1)
#define STEPS_PER_S2 (FASTER * (int32_t)RATE_HZ / 16)

void motion_begin(void);
void motion_follow(void); /* the program, from where the motor stands */
void motion_halt(void); /* at once, wherever the motor is */
enum news motion_tick(int32_t motor_counts);
uint16_t motion_stroke(void); /* number of the stroke under way or just ended, from 1 */

#endif
