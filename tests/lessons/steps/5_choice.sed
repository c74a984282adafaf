# no choice per span: always floor(c + 1/2)
s/return 16384.5 + (rises ? 0x1p-21 : -0x1p-21);/return (void)rises, 16384.5 + 0x1p-21;/
