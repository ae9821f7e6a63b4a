/* Stands for libjbig in a wheel, so that no library under the GPL is in it: libtiff, as Debian has it, links JBIG-KIT. Pictures
 * compressed so, faxes of two colours, are then damaged files to libtiff, with the words of jbg_strerror(). */
enum
{
  Refused = 1
};

void
jbg_dec_init(void * state)
{
  (void)state;
}

int
jbg_dec_in(void * state, unsigned char * data, unsigned long length, unsigned long * count)
{
  (void)state;
  (void)data;
  (void)length;
  if (count)
  {
    *count = 0;
  }
  return Refused;
}

int
jbg_newlen(unsigned char * data, unsigned long length)
{
  (void)data;
  (void)length;
  return Refused;
}

unsigned char *
jbg_dec_getimage(const void * state, int plane)
{
  (void)state;
  (void)plane;
  return 0;
}

unsigned long
jbg_dec_getsize(const void * state)
{
  (void)state;
  return 0;
}

void
jbg_dec_free(void * state)
{
  (void)state;
}

const char *
jbg_strerror(int code)
{
  (void)code;
  return "JBIG is not read by this wheel of dentalscr";
}

/* Nothing of ours writes such pictures: what is encoded is empty. */
void
jbg_enc_init(void * state, unsigned long width, unsigned long height, int planes, unsigned char ** image, void * out, void * file)
{
  (void)state;
  (void)width;
  (void)height;
  (void)planes;
  (void)image;
  (void)out;
  (void)file;
}

void
jbg_enc_out(void * state)
{
  (void)state;
}

void
jbg_enc_free(void * state)
{
  (void)state;
}
