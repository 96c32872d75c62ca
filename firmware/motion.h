/* The experiment: rest, then so many times wind, hold, unwind, rest. Called once a sample; knows no hardware. */
#ifndef MOTION_H
#define MOTION_H

#include <stdint.h>

enum news { NOTHING, STROKE_STARTS, STROKE_ENDS, FINISHED, STALLED };

void motion_begin(void);
void motion_halt(void); /* at once, wherever the motor is */
enum news motion_tick(int32_t motor_counts);
uint16_t motion_stroke(void); /* number of the stroke under way or just ended, from 1 */

#endif
