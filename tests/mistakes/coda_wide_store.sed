# stage5_asm/coda.S: coda: the coda's calls touch frame and texture only, and keep the calling convention
# A row's last group ends a pixel too far.
s|lea     rbx, \[r11 + rcx \* 4\]|lea     rbx, [r11 + rcx * 4 + 4]|
