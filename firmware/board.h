/* What the firmware asks of a board. board_uno.c is the Arduino's; another board needs one file like it. */
#ifndef BOARD_H
#define BOARD_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __AVR__
#include <avr/pgmspace.h>
#else
#define PROGMEM
#define pgm_read_byte(address) (*(const char *)(address))
#define pgm_read_dword(address) (*(const uint32_t *)(address))
#endif

/* What the sensors said at one moment, and how many moments before it found no room to be kept. */
struct sample {
    uint32_t t_us;
    int32_t motor_counts;
    int32_t displacement_counts;
    uint16_t load_steps;
    uint16_t missed;
};

void board_begin(void);
void board_rest(void); /* until there is something to do */
uint32_t board_nonce(void); /* another one after every boot */

/* The serial line. */
void board_put(uint8_t byte); /* waits while there is no room */
uint8_t board_room(void); /* bytes that can be put without waiting */
bool board_get(uint8_t *byte);

/* The sensors, RATE_HZ times a second from boot on. */
bool board_sample(struct sample *sample); /* the oldest one that was not asked for yet */
bool board_skipped(void); /* whether an encoder's edges came faster than they could be counted */

/* The motor: counts its steps from 0 at boot, winding positive. */
void board_drive(int32_t target_steps, uint16_t steps_per_s); /* on to there, at that speed */
int32_t board_steps(void);

#endif
