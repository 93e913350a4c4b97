// SPDX-License-Identifier: Apache-2.0
//
// A jaw sensor that speaks JAW1 (devices/jaw_sensor/jaw_sensor.md), for boards of the Arduino family. The demodulator's output, a
// Hall sensor or the middle of a potentiometer goes to A0, and a strain gauge's amplifier, if there is one, to A1.
const char *SERIAL_NUMBER = "JAW-001";  // another one on each sensor: calibrations are kept by it
const float UV_PER_STEP = 5.0e6 / 1024; // microvolt per step: reference / steps. 10 bits at 5 V; better: a 16-bit ADS1115
const bool HAS_GRIP = false;            // a strain gauge at A1
const float MN_PER_STEP = 10.0;         // millinewton per step of it

unsigned long sequence = 0, next_us = 0, period_us = 5000; // 200 Hz
byte status = 16;                                           // bit 4: has restarted
bool binary = false;

byte crc8(const char *s) {
  byte crc = 0;
  for (; *s; ++s) {
    crc ^= *s;
    for (byte i = 0; i < 8; ++i) crc = (crc << 1) ^ (crc & 0x80 ? 0x07 : 0);
  }
  return crc;
}
void say(const char *body) {
  char check[6];
  sprintf(check, "*%02X\n", crc8(body));
  Serial.print('$'), Serial.print(body), Serial.print(check);
}
void frame(byte type, unsigned long clock_us, long value) {
  byte p[10] = {type, (byte)sequence, (byte)clock_us, (byte)(clock_us >> 8), (byte)value, (byte)(value >> 8), (byte)(value >> 16), status};
  unsigned int crc = 0xFFFF;
  for (byte i = 0; i < 8; ++i) {
    crc ^= (unsigned int)p[i] << 8;
    for (byte k = 0; k < 8; ++k) crc = (crc << 1) ^ (crc & 0x8000 ? 0x1021 : 0);
  }
  p[8] = crc, p[9] = crc >> 8;
  for (byte begin = 0, i = 0; begin <= 10; begin = i + 1) { // COBS: runs without a zero, each after its length
    for (i = begin; i < 10 && p[i]; ++i) {}
    Serial.write(i - begin + 1), Serial.write(p + begin, i - begin);
  }
  Serial.write((byte)0);
}
void measurement(byte type, const char *name, unsigned long clock_us, long value) {
  char body[64];
  sprintf(body, "%s,%lu,%lu,%ld,%02X", name, sequence, clock_us, value, status);
  if (binary) frame(type, clock_us, value); else say(body);
  ++sequence;
}
void obey(const char *word) {
  if (word[0] == 'B') {
    if (word[1] == '1' && !binary) Serial.write((byte)0);
    binary = word[1] == '1';
  } else if (word[0] == 'R' && atol(word + 1) > 0) {
    period_us = max(1000000UL / atol(word + 1), 1000UL);
  } else if (word[0] == '?' && !binary) {
    char body[48];
    sprintf(body, "INF,serial,%s", SERIAL_NUMBER), say(body);
    say("INF,name,Arduino jaw sensor"), say("INF,fw,1"), say(HAS_GRIP ? "INF,channels,JAW GRP" : "INF,channels,JAW");
  }
}
void setup() { Serial.begin(115200); }
void loop() {
  static char word[16];
  static byte n = 0;
  while (Serial.available()) {
    const char c = Serial.read();
    if (c == '\n') word[n] = 0, n = 0, obey(word);
    else if (n < 15) word[n++] = c;
  }
  if ((long)(micros() - next_us) < 0) return;
  next_us = micros() - next_us > period_us ? micros() + period_us : next_us + period_us;
  const unsigned long clock_us = micros();
  const int raw = analogRead(A0);
  status = (status & 16) | (raw >= 1020 ? 1 : 0) | (raw <= 3 ? 2 : 0); // at the end of its range
  measurement(1, "JAW", clock_us, raw * UV_PER_STEP);
  if (HAS_GRIP) measurement(2, "GRP", clock_us, analogRead(A1) * MN_PER_STEP);
  status = 0;
}
