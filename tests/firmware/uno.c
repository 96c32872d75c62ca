/* An Arduino Uno in simavr: runs the firmware of the file that is named, its pins on a motor with two encoders. */
#include "bench.h"

#include <simavr/avr_adc.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>

#define EDGE_CYCLES 400 /* between two edges of an encoder: 25 us */
#define LOOK_CYCLES 1600

static avr_t *avr;
static avr_irq_t *uart_in;
static bool uart_takes = true, winds = true;
static int32_t steps;

/* An encoder's count, and the port and the first of the two pins on which it shows. */
struct encoder {
    int32_t counts;
    char port;
    uint8_t pin;
};
static struct encoder motor = {0, 'D', 2}, displacement = {0, 'B', 0};

static void said(avr_irq_t *irq, uint32_t byte, void *nothing)
{
    (void)irq, (void)nothing;
    line_put((uint8_t)byte);
}

static void takes(avr_irq_t *irq, uint32_t value, void *yes)
{
    (void)irq, (void)value;
    uart_takes = yes != NULL;
}

static void direction(avr_irq_t *irq, uint32_t level, void *nothing)
{
    (void)irq, (void)nothing;
    winds = !level;
}

static void step(avr_irq_t *irq, uint32_t level, void *nothing)
{
    (void)irq, (void)nothing;
    if (level)
        steps += winds ? 1 : -1;
}

static void show(const struct encoder *encoder)
{
    static const uint8_t states[4] = {0, 2, 3, 1}; /* A is bit 0, B bit 1 */
    uint8_t state = states[encoder->counts & 3];
    /* simavr sets inputs anew whenever an output of their port changes: to this */
    avr_ioport_external_t level = {
        .name = (unsigned)encoder->port & 0x7F, .mask = 3u << encoder->pin & 0xFF, .value = state << encoder->pin & 0xFF};
    avr_ioctl(avr, AVR_IOCTL_IOPORT_SET_EXTERNAL(encoder->port), &level);
    for (int pin = 0; pin < 2; pin++)
        avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ(encoder->port), encoder->pin + pin), state >> pin & 1);
}

/* One edge on, or back, to where an encoder should be. */
static void follow(struct encoder *encoder, int32_t counts)
{
    if (encoder->counts == counts)
        return;
    encoder->counts += encoder->counts < counts ? 1 : -1;
    show(encoder);
}

static avr_cycle_count_t edges(avr_t *one, avr_cycle_count_t when, void *nothing)
{
    (void)one, (void)nothing;
    follow(&motor, motor_at(steps));
    follow(&displacement, displacement_at(motor.counts, (double)EDGE_CYCLES / 16000000));
    return when + EDGE_CYCLES;
}

static avr_cycle_count_t look(avr_t *one, avr_cycle_count_t when, void *nothing)
{
    (void)one, (void)nothing;
    uint8_t byte;
    if (uart_takes && line_get(&byte))
        avr_raise_irq(uart_in, byte);
    return when + LOOK_CYCLES;
}

static void slept(avr_t *one, avr_cycle_count_t cycles)
{
    (void)one, (void)cycles; /* main keeps the pace */
}

int main(int count, char **names)
{
    static elf_firmware_t firmware;
    if (count != 2 || elf_read_firmware(names[1], &firmware) != 0)
        return 2;
    avr = avr_make_mcu_by_name("atmega328p");
    avr_init(avr);
    firmware.frequency = 16000000;
    firmware.vcc = firmware.avcc = firmware.aref = 5000;
    avr_load_firmware(avr, &firmware);
    avr->sleep = slept;

    show(&motor);
    show(&displacement);
    uint32_t flags = 0;
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags); /* no echo to our output, no sleeping */
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT), said, NULL);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XON), takes, avr);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUT_XOFF), takes, NULL);
    uart_in = avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), 5), step, NULL);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ('D'), 6), direction, NULL);
    avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC0), LOAD_STEPS * 5000 / 1024 + 3);
    avr_cycle_timer_register(avr, EDGE_CYCLES, edges, NULL);
    avr_cycle_timer_register(avr, LOOK_CYCLES, look, NULL);

    line_open();
    double began_s = now_s(), pace = setting("PACE", 1);
    int32_t reset_after_steps = (int32_t)setting("RESET_AFTER_STEPS", -1);
    for (int state = cpu_Running; state != cpu_Done && state != cpu_Crashed;) {
        for (int turn = 0; turn < 1000; turn++)
            state = avr_run(avr);
        if (steps == reset_after_steps) {
            reset_after_steps = -1;
            avr_reset(avr);
        }
        double ahead_s = (double)avr->cycle / avr->frequency - (now_s() - began_s) * pace;
        if (ahead_s > 0)
            usleep((useconds_t)(ahead_s / pace * 1e6));
    }
    return 1;
}
