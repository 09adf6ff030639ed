const float seen_depth_m = 0.01;  // water that is less deep is not shown by views of it
