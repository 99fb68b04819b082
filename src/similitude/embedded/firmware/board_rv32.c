/* What the stream needs of a RISC-V under QEMU: start, semihosting, a counter of instructions. */

#include "board.h"

void begin(void);

__asm(".option arch, +zicsr\n.section .vectors,\"ax\"\n.globl reset\nreset:\n la sp, stack_top\n la t0, trapped\n csrw mtvec, t0\n"
      " jal begin\n.balign 4\ntrapped:\n li a0, 1\n jal leave\n.text\n");

void begin(void)
{
    stream();
    leave(0);
}

unsigned long ticks(void)
{
    unsigned long now;
    __asm volatile(".option push\n.option arch, +zicsr\n csrr %0, minstret\n.option pop" : "=r"(now));
    return now & 0xFFFFFFul;
}

unsigned long instructions(unsigned long counted)
{
    return counted;
}

long call_host(long operation, void *argument)
{
    register long a0 __asm("a0") = operation;
    register void *a1 __asm("a1") = argument;
    __asm volatile(".balign 16\n.option push\n.option norvc\n slli x0, x0, 0x1f\n ebreak\n srai x0, x0, 7\n"
                   ".option pop\n"
                   : "+r"(a0)
                   : "r"(a1)
                   : "memory");
    return a0;
}
