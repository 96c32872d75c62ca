/* Frames of docs/protocol.md, version 2, byte by byte: COBS( kind | seq | payload | crc ) and a zero. Knows no hardware. */
#ifndef WIRE_H
#define WIRE_H

#include <stdbool.h>
#include <stdint.h>

enum kind {
    HELLO = 0x01, SAMPLE = 0x02, EVENT = 0x03, END = 0x04, TAKEN = 0x05,
    GREET = 0x81, START = 0x82, STOP = 0x83, ACK = 0x84, LEG = 0x85, PROGRAM = 0x86, BEAT = 0x87
};

/* Bytes on the line of a frame with a payload of up to 246 bytes: kind, seq, crc, one byte of COBS and the zero. */
#define FRAME_BYTES(payload) ((payload) + 11)

#define MOST_PAYLOAD 14 /* of the host's frames */

struct command {
    uint8_t kind;
    uint32_t seq;
    uint8_t length;
    uint8_t payload[MOST_PAYLOAD];
};

uint32_t crc_of(uint32_t sum, uint8_t byte); /* one byte more; start with 0xFFFFFFFF, invert at the end */
uint32_t u32_at(const uint8_t *bytes);

/* A frame goes out between begin and end; its payload in the pieces between them, low byte first. */
void frame_begin(enum kind kind, uint32_t seq);
void frame_u8(uint8_t number);
void frame_u16(uint16_t number);
void frame_u32(uint32_t number);
void frame_end(void);

/* Takes the host's bytes one by one; true when one ends a good frame, which then stands in `command`. */
bool frame_heard(uint8_t byte, struct command *command);

#endif
