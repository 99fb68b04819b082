/* What the stream needs of a Cortex-M under QEMU: start, semihosting, a counter of instructions. */

#include "board.h"

extern unsigned long stack_top;
void reset(void);
void stuck(void);

__attribute__((section(".vectors"), used)) static void *const vectors[16] = {
    (void *)&stack_top, (void *)reset, (void *)stuck, (void *)stuck, (void *)stuck, (void *)stuck};

#define WORD_AT(address) (*(volatile unsigned long *)(address))

void reset(void)
{
#if defined(__ARM_FP)
    WORD_AT(0xE000ED88ul) |= 0xF00000ul; /* CPACR: the floating-point unit is ours */
    __asm volatile("dsb\n isb");
#endif
    WORD_AT(0xE000E014ul) = 0xFFFFFFul; /* SysTick: count down from 2^24 - 1 ... */
    WORD_AT(0xE000E018ul) = 0ul;
    WORD_AT(0xE000E010ul) = 5ul; /* ... at the clock of the core, without an interrupt */
    stream();
    leave(0);
}

void stuck(void)
{
    leave(1);
}

unsigned long ticks(void)
{
    return 0xFFFFFFul - WORD_AT(0xE000E018ul);
}

/* QEMU's -icount shift=10 lets an instruction take 1024 ns; the counter runs at 25 or 16 MHz. */
unsigned long instructions(unsigned long counted)
{
#if defined(__ARM_ARCH_6M__)
    return ((counted * 1000ul) + 8192ul) / 16384ul;
#else
    return ((counted * 10ul) + 128ul) / 256ul;
#endif
}

long call_host(long operation, void *argument)
{
    register long r0 __asm("r0") = operation;
    register void *r1 __asm("r1") = argument;
    __asm volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
    return r0;
}
