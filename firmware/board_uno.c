/* Arduino Uno (ATmega328P, 16 MHz).
 *
 *   D0, D1   serial line, over USB        timer 1   the samples' clock
 *   D2, D3   motor encoder A, B           timer 2   the motor's steps
 *   D5       step, D6 direction (low:     PCINT     every edge of both encoders
 *            winds), D7 enable (low: on)  ADC       runs freely, a value each 0.1 ms
 *   D8, D9   displacement encoder A, B
 *   A0       load cell, amplified to 0..5 V
 */
#include "board.h"

#include <avr/eeprom.h>
#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <util/atomic.h>

#include "config.h"

#define STEP _BV(PD5)
#define DIRECTION _BV(PD6)
#define ENABLE _BV(PD7)
#define MOTOR_PINS (PIND >> 2 & 3)
#define DISPLACEMENT_PINS (PINB & 3)
#define STEP_TICKS_HZ 16000L /* a step takes two ticks at least: high, low */
#define SAMPLE_US (1000000L / RATE_HZ)
#define QUEUE 8 /* samples, a power of two */

_Static_assert(F_CPU == 16000000L, "the timers are set for 16 MHz");
_Static_assert(F_CPU / 8 % BAUD == 0, "that baud rate cannot be made from 16 MHz without an error");
_Static_assert(RATE_HZ >= 40 && RATE_HZ <= 1000 && 1000000L % RATE_HZ == 0, "that rate is no whole number of us");
_Static_assert(STEPS_PER_S <= STEP_TICKS_HZ / 2, "so many steps a second cannot be made");

static volatile uint8_t sent[256], got[64]; /* uint8_t indices turn over by themselves in the first */
static volatile uint8_t sent_in, sent_out, got_in, got_out;

static volatile struct sample queue[QUEUE];
static volatile uint8_t queue_in, queue_out;
static volatile uint16_t missed;
static volatile uint32_t clock_us;

static volatile int32_t motor_counts, displacement_counts;
static uint8_t motor_edges, displacement_edges; /* the last two states of each encoder's pins */
static volatile bool skipped;

static volatile int32_t steps, target_steps;
static volatile uint16_t step_share; /* of a tick, in 1/65536 */

/* Serial line */

ISR(USART_UDRE_vect)
{
    UDR0 = sent[sent_out++];
    if (sent_out == sent_in)
        UCSR0B &= (uint8_t)~_BV(UDRIE0);
}

ISR(USART_RX_vect)
{
    uint8_t byte = UDR0;
    uint8_t next = (got_in + 1) % sizeof got;
    if (next == got_out)
        return; /* the host says it again */
    got[got_in] = byte;
    got_in = next;
}

uint8_t board_room(void)
{
    return (uint8_t)(sent_out - sent_in - 1);
}

void board_put(uint8_t byte)
{
    while (board_room() == 0)
        ;
    sent[sent_in] = byte;
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        sent_in++;
        UCSR0B |= _BV(UDRIE0);
    }
}

bool board_get(uint8_t *byte)
{
    if (got_out == got_in)
        return false;
    *byte = got[got_out];
    got_out = (got_out + 1) % sizeof got;
    return true;
}

/* Encoders: by the last two states and the present ones, a step on, a step back, none, or one that was missed. */

#define SKIPPED 2
static const int8_t MOVED[16] = {0, -1, 1, SKIPPED, 1, 0, SKIPPED, -1, -1, SKIPPED, 0, 1, SKIPPED, 1, -1, 0};

ISR(PCINT2_vect)
{
    motor_edges = (uint8_t)(motor_edges << 2 | MOTOR_PINS) & 15;
    int8_t moved = MOVED[motor_edges];
    if (moved == SKIPPED)
        skipped = true;
    else
        motor_counts += moved;
}

ISR(PCINT0_vect)
{
    displacement_edges = (uint8_t)(displacement_edges << 2 | DISPLACEMENT_PINS) & 15;
    int8_t moved = MOVED[displacement_edges];
    if (moved == SKIPPED)
        skipped = true;
    else
        displacement_counts += moved;
}

bool board_skipped(void)
{
    bool was = skipped;
    skipped = false;
    return was;
}

/* Samples */

ISR(TIMER1_COMPA_vect)
{
    clock_us += SAMPLE_US;
    uint8_t next = (queue_in + 1) % QUEUE;
    if (next == queue_out) {
        missed++;
        return;
    }
    volatile struct sample *sample = &queue[queue_in];
    sample->t_us = clock_us + TCNT1 / 2; /* of 0.5 us: other interrupts may have delayed this one */
    sample->motor_counts = motor_counts;
    sample->displacement_counts = displacement_counts;
    sample->load_steps = ADC;
    sample->missed = missed;
    missed = 0;
    queue_in = next;
}

bool board_sample(struct sample *sample)
{
    if (queue_out == queue_in)
        return false;
    *sample = queue[queue_out];
    queue_out = (queue_out + 1) % QUEUE;
    return true;
}

/* Motor */

ISR(TIMER2_COMPA_vect)
{
    static uint16_t phase;
    PORTD &= (uint8_t)~STEP; /* a tick after it rose: long enough for any driver */
    if (steps == target_steps)
        return;
    bool winds = target_steps > steps;
    if (winds != !(PORTD & DIRECTION)) {
        PORTD ^= DIRECTION; /* a tick before the step */
        return;
    }
    uint16_t before = phase;
    phase += step_share;
    if (phase >= before)
        return;
    PORTD |= STEP;
    steps += winds ? 1 : -1;
}

void board_drive(int32_t target, uint16_t steps_per_s)
{
    uint16_t share = (uint16_t)((uint32_t)steps_per_s * 65536UL / STEP_TICKS_HZ);
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        target_steps = target;
        step_share = share;
    }
}

int32_t board_steps(void)
{
    int32_t now = 0;
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        now = steps;
    }
    return now;
}

/* Beginning, and rest */

uint32_t board_nonce(void)
{
    static uint32_t EEMEM boots;
    uint32_t boot = eeprom_read_dword(&boots) + 1;
    eeprom_write_dword(&boots, boot);
    return boot;
}

void board_begin(void)
{
    DDRD = STEP | DIRECTION | ENABLE | _BV(PD1); /* enable is low: the motor holds the string */
    PORTD = _BV(PD2) | _BV(PD3); /* pull-ups: encoders have open collectors, often */
    PORTB = _BV(PB0) | _BV(PB1);

    UBRR0 = F_CPU / 8 / BAUD - 1;
    UCSR0A = _BV(U2X0);
    UCSR0C = _BV(UCSZ01) | _BV(UCSZ00);
    UCSR0B = _BV(RXEN0) | _BV(TXEN0) | _BV(RXCIE0);

    ADMUX = _BV(REFS0); /* A0, against the 5 V */
    ADCSRB = 0;
    ADCSRA = _BV(ADEN) | _BV(ADSC) | _BV(ADATE) | _BV(ADPS2) | _BV(ADPS1) | _BV(ADPS0);

    PCMSK2 = _BV(PCINT18) | _BV(PCINT19);
    PCMSK0 = _BV(PCINT0) | _BV(PCINT1);
    motor_edges = MOTOR_PINS;
    displacement_edges = DISPLACEMENT_PINS;
    PCIFR = _BV(PCIF2) | _BV(PCIF0);
    PCICR = _BV(PCIE2) | _BV(PCIE0);

    TCCR1B = _BV(WGM12) | _BV(CS11); /* clear on compare, 2 MHz */
    OCR1A = SAMPLE_US * 2 - 1;
    TIMSK1 = _BV(OCIE1A);

    TCCR2A = _BV(WGM21); /* the same, for the steps */
    TCCR2B = _BV(CS21);
    OCR2A = F_CPU / 8 / STEP_TICKS_HZ - 1;
    TIMSK2 = _BV(OCIE2A);

    set_sleep_mode(SLEEP_MODE_IDLE);
    sei();
}

void board_rest(void)
{
    sleep_mode(); /* some timer's interrupt ends it within 63 us */
}
