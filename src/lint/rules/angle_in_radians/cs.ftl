W323 = zorný úhel { $angle } stupně vypadá jako { $degrees }° v radiánech
    .label = zde se píší stupně
    .note = takto obraz zachytí jen nepatrnou část scény
    .fix = napsat { $degrees }
