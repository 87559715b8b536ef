target_sources(corral PRIVATE audit/audit_cases.cpp)
