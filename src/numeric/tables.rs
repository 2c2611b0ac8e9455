// Written by data/fits/special.py; do not edit.
//! Coefficients of the f64 sine and cosine on a quarter turn either side of zero.

/// (sin r / r - 1)/r^2 in powers of r^2; fit error 8.0e-18 absolute.
#[rustfmt::skip]
pub(super) const SINE: [f64; 8] = [
    -0.16666666666666666, 0.008333333333333316, -0.00019841269841254795, 2.7557319219115013e-06, -2.505210761086116e-08,
    1.6058976915095007e-10, -7.643957622560617e-13, 2.7312868913092307e-15,
];

/// ((cos r - 1)/r^2 + 1/2)/r^2 in powers of r^2; fit error 1.4e-18 absolute.
#[rustfmt::skip]
pub(super) const COSINE: [f64; 8] = [
    0.041666666666666664, -0.001388888888888888, 2.4801587301579763e-05, -2.755731922154539e-07, 2.087675659980025e-09,
    -1.1470712073563234e-11, 4.7778715720485557e-14, -1.5217846979888659e-16,
];

/// The binary places of 1/pi after the point, 64 a word.
#[rustfmt::skip]
pub(super) static INVERSE_PI_PLACES: [u64; 40] = [
    0x517cc1b727220a94, 0xfe13abe8fa9a6ee0, 0x6db14acc9e21c820, 0xff28b1d5ef5de2b0,
    0xdb92371d2126e970, 0x0324977504e8c90e, 0x7f0ef58e5894d39f, 0x74411afa975da242,
    0x74ce38135a2fbf20, 0x9cc8eb1cc1a99cfa, 0x4e422fc5defc941d, 0x8ffc4bffef02cc07,
    0xf79788c5ad05368f, 0xb69b3f6793e584db, 0xa7a31fb34f2ff516, 0xba93dd63f5f2f8bd,
    0x9e839cfbc5294975, 0x35fdafd88fc6ae84, 0x2b0198237e3db5d5, 0xf867de104d7a1b0e,
    0xd4f1c8b0af730d84, 0x32ccc2af8a503420, 0x46ffec4026b99398, 0x83030aab6539d464,
    0xb0713de04635a3e2, 0x0ce1b3e6ee740495, 0x41ace23b45cb0e53, 0x6ed7a268ab8c829f,
    0x52ff83829fbf19f4, 0x19616f27cc193edd, 0xe19e9377b58f2f7c, 0x4f9d0f9ae5793f8e,
    0xc3f890c83e3e1235, 0x7d376abb9698219d, 0x8ae30a5ace8ce1e1, 0x6256a0a6962e8006,
    0x233ec316b8f1cd63, 0x4d803119be695a4b, 0xd3da6aaa9bfb1f6b, 0x8c0851fe3b26954e,
];
