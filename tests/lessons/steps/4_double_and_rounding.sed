# in float and truncated
s/^typedef double real;/typedef float real;/
s/return 16384.5 + (rises ? 0x1p-21 : -0x1p-21);/return (void)rises, 0;/
