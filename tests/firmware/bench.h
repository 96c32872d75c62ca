/* What the firmware is tried on: a pseudo-terminal for its serial line, and a motor, a string and sensors. */
#ifndef BENCH_H
#define BENCH_H

#include <fcntl.h>
#include <math.h>
#include <poll.h>
#include <pty.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "config.h"

#define RADIUS_MM 1.0
#define LENGTH_MM 300.0
#define MM_A_COUNT 0.005
#define LOAD_STEPS 205 /* of the converter: 20.02 N */

static int line;

/* Open the line and print the host's name for it. */
static inline void line_open(void)
{
    int host;
    char name[64];
    struct termios raw;
    if (openpty(&line, &host, name, NULL, NULL) != 0)
        abort();
    tcgetattr(host, &raw);
    cfmakeraw(&raw);
    tcsetattr(host, TCSANOW, &raw); /* stays open: hosts come and go */
    printf("%s\n", name);
    fflush(stdout);
}

static inline void line_put(uint8_t byte)
{
    if (write(line, &byte, 1) != 1)
        abort();
}

static inline bool line_get(uint8_t *byte)
{
    struct pollfd waiting = {line, POLLIN, 0};
    return poll(&waiting, 1, 0) == 1 && read(line, byte, 1) == 1;
}

static inline double setting(const char *name, double otherwise)
{
    const char *text = getenv(name);
    return text ? atof(text) : otherwise;
}

static inline double now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Encoder counts after so many steps of the motor, which sticks at STALL_TURNS. */
static inline int32_t motor_at(int32_t steps)
{
    double turns = (double)steps / STEPS_PER_TURN;
    return (int32_t)lround(fmin(turns, setting("STALL_TURNS", 1e9)) * MOTOR_COUNTS_PER_TURN);
}

/* Encoder counts of the displacement, so long after the last call: the sensor is late by LAG_S and shakes by SHAKE_MM. */
static inline int32_t displacement_at(int32_t motor_counts, double passed_s)
{
    static double shown_mm, shakes_mm;
    double arc_mm = 2 * M_PI * motor_counts / MOTOR_COUNTS_PER_TURN * RADIUS_MM;
    double true_mm = LENGTH_MM - sqrt(LENGTH_MM * LENGTH_MM - arc_mm * arc_mm);
    double lag_s = setting("LAG_S", 0), shake_mm = setting("SHAKE_MM", 0);
    shown_mm += (true_mm - shown_mm) * (lag_s > 0 ? -expm1(-passed_s / lag_s) : 1);
    if (shake_mm > 0) { /* uniform, of that standard deviation, anew 1000 times a second */
        static double since_s;
        since_s += passed_s;
        if (since_s >= 0.001) {
            shakes_mm = ((double)rand() / RAND_MAX - 0.5) * sqrt(12) * shake_mm;
            since_s -= 0.001;
        }
    }
    return (int32_t)lround((shown_mm + shakes_mm) / MM_A_COUNT);
}

#endif
