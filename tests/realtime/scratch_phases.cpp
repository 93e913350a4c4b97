// scratch
#include <cstdio>
#include "attempt.hpp"
#include "base/clock.hpp"
#include "host/services.hpp"
#include <vector>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
using namespace swage;
int main(int argc,char**argv){
  std::filesystem::remove("/tmp/s.db");
  realtime::Attempt a(argv[1], argc>2?argv[2]:"expert", {SWAGE_BINARY_DIR "/plugins"}, "/tmp/s.db");
  if(!a.ok()) return 2;
  host::set_thread_role(SWAGE_THREAD_RT);
  double prev[snapshot::kPhases]={};
  std::vector<double> all;
  int n=0; bool go=true;
  while(go){
    int64_t c0=base::cpu_ns(); go=a.tick(); double us=1e-3*(base::cpu_ns()-c0);
    all.push_back(us);
    printf("%d %.1f",n++,us);
    for(uint32_t p=0;p<snapshot::kPhases;++p){double now=a.engine().phase_s()[p]; printf(" %.1f",1e6*(prev[p]+256*(now-prev[p]))); prev[p]=now;}
    auto&s=a.engine().stats(); printf(" c%zu it%d nc%d fb%d rd%d rf%d\n",a.engine().contacts().contact.size(),(int)s.newton,(int)s.not_converged,(int)s.fallbacks,(int)s.rounds,(int)s.refreshed);
    timespec t{0,200000}; if(argc>3) nanosleep(&t,nullptr);
  }
  std::sort(all.begin(),all.end());
  fprintf(stderr,"p50 %.1f p90 %.1f p95 %.1f p99 %.1f p99.9 %.1f max %.1f\n",all[all.size()/2],all[all.size()*9/10],all[all.size()*95/100],all[all.size()*99/100],all[all.size()*999/1000],all.back());
}
