/* What a lab changes: the numbers of its rig. Each can be set from the command line too (-D STROKES=3). */
#ifndef CONFIG_H
#define CONFIG_H

#ifndef DEVICE
#define DEVICE "TSA rig, Arduino Uno"
#endif
#ifndef BAUD
#define BAUD 1000000 /* 16 MHz give 1 M, 500 k and 250 k without an error; 115200 would be 2 % off */
#endif
#ifndef RATE_HZ
#define RATE_HZ 1000 /* samples a second, 40 to 1000 */
#endif

/* Sensors: value = scale * integer + offset. Swap an encoder's two wires if it counts the wrong way. */
#ifndef MOTOR_COUNTS_PER_TURN
#define MOTOR_COUNTS_PER_TURN 4096 /* four for each line of the encoder */
#define MOTOR_SCALE "0.000244140625" /* turns a count */
#endif
#ifndef DISPLACEMENT_SCALE
#define DISPLACEMENT_SCALE "0.005" /* mm a count; contraction positive */
#endif
#ifndef LOAD_SCALE
#define LOAD_SCALE "0.09765625" /* N a step of the converter: 1024 steps are 100 N */
#define LOAD_OFFSET "0"
#endif

/* The motor, a stepper behind a step/direction driver. */
#ifndef STEPS_PER_TURN
#define STEPS_PER_TURN 1600L
#endif
#ifndef STEPS_PER_S
#define STEPS_PER_S 3200L /* at most 8000 */
#endif
#ifndef RAMP_MS
#define RAMP_MS 250L /* from standstill to that speed */
#endif

/* Programs of motion from the host: twist from 0 to TOP_TURNS, speed and ramps as above, the load as it hangs. */
#ifndef MOST_LEGS
#define MOST_LEGS 48 /* eight bytes each */
#endif
#ifndef LONGEST_S
#define LONGEST_S 3600UL
#endif
#ifndef SILENCE_MS
#define SILENCE_MS 1500L /* of the host, after which the motor is stopped */
#endif

/* The experiment: rest, then STROKES times wind, hold, unwind, rest. */
#ifndef STROKES
#define STROKES 9
#endif
#ifndef TOP_TURNS
#define TOP_TURNS 27L
#endif
#ifndef HOLD_MS
#define HOLD_MS 1000L
#endif
#ifndef REST_MS
#define REST_MS 2000L
#endif

#endif
