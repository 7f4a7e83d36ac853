<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR" sourcelanguage="en">
<context>
    <name>Findings</name>
    <message>
        <source>the surface is held at a neck of radius {radius_mm:3g} mm: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>la surface est retenue à un rétrécissement de {radius_mm:3g} mm de rayon : au-delà, les mêmes intensités se poursuivent sur au moins {behind_ml:3g} ml, en deçà elles remplissent {in_front_ml:3g} ml ; si cela appartient à l’objet, placez-y aussi un germe ou fixez l’intervalle à l’étape 3, Régler, qui ne retient rien</translation>
    </message>
    <message>
        <source>the surface is held at a hole of radius {radius_mm:3g} mm in a thin wall: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>la surface est retenue à un trou de {radius_mm:3g} mm de rayon dans une paroi mince : au-delà, les mêmes intensités se poursuivent sur au moins {behind_ml:3g} ml, en deçà elles remplissent {in_front_ml:3g} ml ; si cela appartient à l’objet, placez-y aussi un germe ou fixez l’intervalle à l’étape 3, Régler, qui ne retient rien</translation>
    </message>
    <message>
        <source>the surface is held where its structure grows wider than a radius of {radius_mm:3g} mm: behind it the same intensities go on for at least {behind_ml:3g} ml, in front of it they fill {in_front_ml:3g} ml; where that belongs to the object, put a seed there too, or set the range in step 3, Tune, which holds nothing back</source>
        <translation>la surface est retenue là où sa structure dépasse {radius_mm:3g} mm de rayon : au-delà, les mêmes intensités se poursuivent sur au moins {behind_ml:3g} ml, en deçà elles remplissent {in_front_ml:3g} ml ; si cela appartient à l’objet, placez-y aussi un germe ou fixez l’intervalle à l’étape 3, Régler, qui ne retient rien</translation>
    </message>
    <message>
        <source>the surface got stuck: no part of a step could be kept, again and again; another edge length may help</source>
        <translation>la surface est bloquée : à plusieurs reprises, aucune partie d’un pas n’a pu être conservée ; une autre longueur d’arête peut aider</translation>
    </message>
    <message>
        <source>the surface rests at places that would still move, because changes there failed or repeated again and again; another edge length or smoothing may help</source>
        <translation>la surface est au repos à des endroits qui bougeraient encore, car les changements y ont échoué ou se sont répétés ; une autre longueur d’arête ou un autre lissage peut aider</translation>
    </message>
    <message>
        <source>the surface hardly grew beyond its seed: look at the kind of object and the range in step 3, Tune</source>
        <translation>la surface n’a guère grandi au-delà de son germe : vérifiez le type d’objet et l’intervalle à l’étape 3, Régler</translation>
    </message>
    <message>
        <source>the surface hardly grew beyond its seed: the curvature weight holds every front of a radius below {radius_mm:3g} mm, and the seed is smaller; give it a larger radius, or lower the weight</source>
        <translation>la surface n’a guère grandi au-delà de son germe : le poids de courbure retient tout front de rayon inférieur à {radius_mm:3g} mm, et le germe est plus petit ; donnez-lui un plus grand rayon ou réduisez le poids</translation>
    </message>
    <message>
        <source>the choice among {objects} objects is close (expected overlap with the one that is meant: Dice {dice:2g}): the next candidate holds {next_ml:3m} ml where this one holds {this_ml:3m} ml; another one can be chosen in step 2, Seed</source>
        <translation>le choix entre {objects} objets est serré (recouvrement attendu avec celui qui est visé : Dice {dice:2g}) : le candidat suivant contient {next_ml:3m} ml, celui-ci {this_ml:3m} ml ; un autre peut être choisi à l’étape 2, Germes</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}</source>
        <translation>la surface a fui à l’itération {iteration} : {cause}</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}; a wall was put there</source>
        <translation>la surface a fui à l’itération {iteration} : {cause} ; une barrière y a été placée</translation>
    </message>
    <message>
        <source>the surface leaked at iteration {iteration}: {cause}; the mesh is that of iteration {mesh_iteration}, before it came there</source>
        <translation>la surface a fui à l’itération {iteration} : {cause} ; le maillage est celui de l’itération {mesh_iteration}, avant qu’elle n’y arrive</translation>
    </message>
    <message>
        <source>The seed is not in an object with a boundary of its own: what grows from it fills the field of view, up to the padding around the image. Where that is meant, say whether it is dark or bright, or set the range in step 3, Tune.</source>
        <translation>Le germe n’est pas dans un objet qui a son propre bord : ce qui en grandit remplit le champ de vue jusqu’au remplissage autour de l’image. Si c’est voulu, indiquez s’il est sombre ou clair, ou fixez l’intervalle à l’étape 3, Régler.</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm lies outside the volume.</source>
        <translation>Le germe à {place:1f} mm est hors du volume.</translation>
    </message>
    <message>
        <source>The click outside of the object at {place:1f} mm lies outside the volume.</source>
        <translation>Le point extérieur à {place:1f} mm est hors du volume.</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm is not in the object: the smoothed intensity there is {intensity:4g}, the object's range is {low:4g} to {high:4g}.</source>
        <translation>Le germe à {place:1f} mm n’est pas dans l’objet : l’intensité lissée y est de {intensity:4g}, l’intervalle de l’objet va de {low:4g} à {high:4g}.</translation>
    </message>
    <message>
        <source>The range {low:4g} to {high:4g} holds no voxel of the volume, whose values run from {least:4g} to {most:4g}.</source>
        <translation>L’intervalle de {low:4g} à {high:4g} ne contient aucun voxel du volume, dont les valeurs vont de {least:4g} à {most:4g}.</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies where the image shows no edge: the object may go on there, or the surface leaked</source>
        <translation>{percent:0f} % de la surface se trouve là où l’image ne montre aucun contour : l’objet s’y poursuit peut-être, ou la surface a fui</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies on the border of the volume: the object is cut off there, or the surface leaked</source>
        <translation>{percent:0f} % de la surface se trouve au bord du volume : l’objet y est coupé, ou la surface a fui</translation>
    </message>
    <message>
        <source>{percent:0f} % of the surface lies on the border of the field of view: the object is cut off there, or the surface leaked</source>
        <translation>{percent:0f} % de la surface se trouve au bord du champ de vue : l’objet y est coupé, ou la surface a fui</translation>
    </message>
    <message>
        <source>the surface still lies in a wall that was put over it</source>
        <translation>la surface se trouve encore dans une barrière placée sur elle</translation>
    </message>
    <message>
        <source>at the allowed place {place} nothing came that a limit of the topology would have held</source>
        <translation>au lieu autorisé {place}, rien n’est survenu qu’une limite de la topologie aurait retenu</translation>
    </message>
    <message>
        <source>the surface is held at passages narrower than a radius of {radius_mm:3g} mm; where what lies behind them belongs to the object, put a seed there too, or take a larger candidate</source>
        <translation>la surface est retenue aux passages de moins de {radius_mm:3g} mm de rayon ; si ce qui se trouve au-delà appartient à l’objet, placez-y aussi un germe ou prenez un candidat plus grand</translation>
    </message>
    <message>
        <source>the object reaches the end of what was searched around the seed and is cut off there; where it goes on, put a seed there too</source>
        <translation>l’objet atteint la limite de ce qui a été exploré autour du germe et y est coupé ; là où il se poursuit, placez-y aussi un germe</translation>
    </message>
    <message>
        <source>it came through a passage {width_mm:1f} mm wide at {place:1f} from a space {before_mm:0f} mm wide into one {behind_mm:0f} mm wide</source>
        <translation>elle est passée par un passage de {width_mm:1f} mm de large à {place:1f}, d’un espace de {before_mm:0f} mm vers un espace de {behind_mm:0f} mm</translation>
    </message>
    <message>
        <source>it came through a passage too narrow for the voxels to show at {place:1f} from a space {before_mm:0f} mm wide into one {behind_mm:0f} mm wide</source>
        <translation>elle est passée à {place:1f} par un passage trop étroit pour les voxels, d’un espace de {before_mm:0f} mm vers un espace de {behind_mm:0f} mm</translation>
    </message>
    <message>
        <source>the pin {pin} holds nothing: the mesh is that of iteration {mesh_iteration}, and its iteration never came</source>
        <translation>la fixation {pin} ne retient rien : le maillage est celui de l’itération {mesh_iteration}, et son itération n’est jamais venue</translation>
    </message>
    <message>
        <source>With clicks, smoothing and noise a little different, {runs} of {of} runs leave no surface</source>
        <translation>Avec des points, un lissage et un bruit un peu différents, {runs} essais sur {of} ne laissent aucune surface</translation>
    </message>
    <message>
        <source>With clicks, smoothing and noise a little different, {runs} of {of} runs have another topology</source>
        <translation>Avec des points, un lissage et un bruit un peu différents, {runs} essais sur {of} ont une autre topologie</translation>
    </message>
    <message>
        <source>The volume depends on where exactly is clicked, on smoothing or noise: it changes by {percent:0f} %</source>
        <translation>Le volume dépend de l’endroit exact du clic, du lissage ou du bruit : il varie de {percent:0f} %</translation>
    </message>
    <message>
        <source>The surface was made with an earlier one of the object '{object}', and a replay may make another</source>
        <translation>La surface a été faite avec une version antérieure de l’objet « {object} », et une relecture peut en donner une autre</translation>
    </message>
    <message>
        <source>kept apart here, as asked</source>
        <translation>maintenu séparé ici, comme demandé</translation>
    </message>
    <message>
        <source>held: it would break the limit of the topology</source>
        <translation>retenu : cela dépasserait la limite de la topologie</translation>
    </message>
    <message>
        <source>the same place changed again and again, and rests from now on</source>
        <translation>le même endroit a changé à plusieurs reprises et reste désormais au repos</translation>
    </message>
    <message>
        <source>no part of the step could be kept</source>
        <translation>aucune partie du pas n’a pu être conservée</translation>
    </message>
    <message>
        <source>{fronts} fronts could not be joined at once: {cause}</source>
        <translation>{fronts} fronts n’ont pu être joints d’un coup : {cause}</translation>
    </message>
    <message>
        <source>of {fronts} fronts {left} left for the next round</source>
        <translation>sur {fronts} fronts, {left} restent pour le tour suivant</translation>
    </message>
    <message>
        <source>1 ring added: {cause}</source>
        <translation>1 anneau ajouté : {cause}</translation>
    </message>
    <message>
        <source>{rings} rings added: {cause}</source>
        <translation>{rings} anneaux ajoutés : {cause}</translation>
    </message>
    <message>
        <source>there may be a shorter handle</source>
        <translation>il existe peut-être une anse plus courte</translation>
    </message>
    <message>
        <source>the surface came to a pinned part, and stops before it</source>
        <translation>la surface est arrivée à une partie fixée et s’arrête devant</translation>
    </message>
    <message>
        <source>to close the place would take too much work</source>
        <translation>fermer cet endroit demanderait trop de travail</translation>
    </message>
    <message>
        <source>the work that a step may take is done: the place waits</source>
        <translation>le travail permis à un pas est fait : l’endroit attend</translation>
    </message>
    <message>
        <source>the fronts meet through the inside of the object</source>
        <translation>les fronts se rencontrent à travers l’intérieur de l’objet</translation>
    </message>
    <message>
        <source>no handle fits</source>
        <translation>aucune anse ne convient</translation>
    </message>
    <message>
        <source>no patch fits</source>
        <translation>aucune pièce ne convient</translation>
    </message>
    <message>
        <source>the component encloses a place where no surface may go</source>
        <translation>la composante entoure un endroit où aucune surface ne peut aller</translation>
    </message>
    <message>
        <source>the opening is too large</source>
        <translation>l’ouverture est trop grande</translation>
    </message>
    <message>
        <source>a pinned part lies there</source>
        <translation>une partie fixée s’y trouve</translation>
    </message>
    <message>
        <source>nothing of the component would be left</source>
        <translation>il ne resterait rien de la composante</translation>
    </message>
    <message>
        <source>the surface would have entered a wall</source>
        <translation>la surface serait entrée dans une barrière</translation>
    </message>
    <message>
        <source>a part of the surface has changed that detection had not looked at</source>
        <translation>une partie de la surface a changé sans que la détection l’ait examinée</translation>
    </message>
    <message>
        <source>the events of the step do not follow from each other</source>
        <translation>les événements du pas ne se suivent pas</translation>
    </message>
    <message>
        <source>the Euler number is not the one that the events predict</source>
        <translation>le nombre d’Euler n’est pas celui que prédisent les événements</translation>
    </message>
    <message>
        <source>the components are not those that the events predict</source>
        <translation>les composantes ne sont pas celles que prédisent les événements</translation>
    </message>
    <message>
        <source>a cavity lies outside of any body</source>
        <translation>une cavité se trouve hors de tout corps</translation>
    </message>
    <message>
        <source>a body lies directly in another</source>
        <translation>un corps se trouve directement dans un autre</translation>
    </message>
    <message>
        <source>the surface still intersected itself after several changes</source>
        <translation>la surface se coupait encore elle-même après plusieurs changements</translation>
    </message>
    <message>
        <source>the surface does not enclose a volume</source>
        <translation>la surface n’enferme aucun volume</translation>
    </message>
    <message>
        <source>the surface would close over a pinned part, and stops before it</source>
        <translation>la surface se refermerait sur une partie fixée et s’arrête avant</translation>
    </message>
    <message>
        <source>a pinned part would have changed</source>
        <translation>une partie fixée aurait changé</translation>
    </message>
    <message>
        <source>the surface would come into a wall or around it</source>
        <translation>la surface entrerait dans une barrière ou l’entourerait</translation>
    </message>
    <message>
        <source>a pinned part would change</source>
        <translation>une partie fixée changerait</translation>
    </message>
    <message>
        <source>there would be more components than may be</source>
        <translation>il y aurait plus de composantes que permis</translation>
    </message>
    <message>
        <source>there would be more tunnels than may be</source>
        <translation>il y aurait plus de tunnels que permis</translation>
    </message>
    <message>
        <source>an edge has only one face</source>
        <translation>une arête n’a qu’une face</translation>
    </message>
    <message>
        <source>two faces disagree about their common edge</source>
        <translation>deux faces sont en désaccord sur leur arête commune</translation>
    </message>
    <message>
        <source>the two faces of an edge run in the same direction or have other ends</source>
        <translation>les deux faces d’une arête vont dans le même sens ou ont d’autres extrémités</translation>
    </message>
    <message>
        <source>two faces have the same three vertices</source>
        <translation>deux faces ont les trois mêmes sommets</translation>
    </message>
    <message>
        <source>a face has a vertex that was removed</source>
        <translation>une face a un sommet qui a été supprimé</translation>
    </message>
    <message>
        <source>a face has a vertex twice</source>
        <translation>une face a deux fois le même sommet</translation>
    </message>
    <message>
        <source>a vertex has no face</source>
        <translation>un sommet n’a pas de face</translation>
    </message>
    <message>
        <source>a vertex names a half-edge that does not leave it</source>
        <translation>un sommet désigne une demi-arête qui ne part pas de lui</translation>
    </message>
    <message>
        <source>two edges join the same two vertices</source>
        <translation>deux arêtes joignent les deux mêmes sommets</translation>
    </message>
    <message>
        <source>the faces around a vertex form more than one fan</source>
        <translation>les faces autour d’un sommet forment plus d’un éventail</translation>
    </message>
    <message>
        <source>the counts of the mesh are not those of its elements</source>
        <translation>les comptes du maillage ne sont pas ceux de ses éléments</translation>
    </message>
    <message>
        <source>no vertex of the surface lies in the ball</source>
        <translation>aucun sommet de la surface n’est dans la boule</translation>
    </message>
    <message>
        <source>the plane does not meet the surface</source>
        <translation>le plan ne rencontre pas la surface</translation>
    </message>
    <message>
        <source>the plane does not meet the surface near that place</source>
        <translation>le plan ne rencontre pas la surface près de cet endroit</translation>
    </message>
    <message>
        <source>no flat cap fits the cut</source>
        <translation>aucun couvercle plan ne convient à la coupe</translation>
    </message>
    <message>
        <source>the cut does not part the body there: both of its sides hang together</source>
        <translation>la coupe ne sépare pas le corps à cet endroit : ses deux côtés tiennent ensemble</translation>
    </message>
    <message>
        <source>the pull goes too far for its radius</source>
        <translation>la traction va trop loin pour son rayon</translation>
    </message>
    <message>
        <source>nothing of the surface would be left</source>
        <translation>il ne resterait rien de la surface</translation>
    </message>
    <message>
        <source>the surface would meet itself there</source>
        <translation>la surface s’y rencontrerait elle-même</translation>
    </message>
    <message>
        <source>No seed was given: at least one is needed.</source>
        <translation>Aucun germe n’a été donné : il en faut au moins un.</translation>
    </message>
    <message>
        <source>The radius of a seed must be a number of mm above 0.</source>
        <translation>Le rayon d’un germe doit être un nombre de mm supérieur à 0.</translation>
    </message>
    <message>
        <source>The seed is not in a dark object: the image has no clear boundary of that kind around it.</source>
        <translation>Le germe n’est pas dans un objet sombre : l’image n’a autour de lui aucun bord net de ce type.</translation>
    </message>
    <message>
        <source>The seed is not in a bright object: the image has no clear boundary of that kind around it.</source>
        <translation>Le germe n’est pas dans un objet clair : l’image n’a autour de lui aucun bord net de ce type.</translation>
    </message>
    <message>
        <source>The seed is not in a dark or bright object: the image has no clear boundary of that kind around it.</source>
        <translation>Le germe n’est pas dans un objet sombre ou clair : l’image n’a autour de lui aucun bord net de ce type.</translation>
    </message>
    <message>
        <source>The range is empty: its lower end is above its upper end.</source>
        <translation>L’intervalle est vide : sa borne inférieure est au-dessus de la supérieure.</translation>
    </message>
    <message>
        <source>Clicks outside of the object and a given range do not go together: the range alone says where the object ends.</source>
        <translation>Des points extérieurs et un intervalle donné ne vont pas ensemble : l’intervalle seul dit où l’objet finit.</translation>
    </message>
    <message>
        <source>The edge length of {edge_mm} mm is too short for the seeds: their surface alone would have over two million triangles.</source>
        <translation>La longueur d’arête de {edge_mm} mm est trop courte pour les germes : leur surface seule aurait plus de deux millions de triangles.</translation>
    </message>
    <message>
        <source>The seed at {place} mm lies in the object '{object}', which is done already.</source>
        <translation>Le germe à {place} mm est dans l’objet « {object} », déjà terminé.</translation>
    </message>
    <message>
        <source>A wall lies over the seed at {place} mm.</source>
        <translation>Une barrière recouvre le germe à {place} mm.</translation>
    </message>
    <message>
        <source>A wall leaves the seed at {place} mm no room.</source>
        <translation>Une barrière ne laisse pas de place au germe à {place} mm.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies within the surface, which cannot be pushed out of it: go back to before it came in there.</source>
        <translation>La barrière à {place} mm se trouve dans la surface, qui ne peut en être repoussée : revenez avant qu’elle n’y soit entrée.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies across surface that is already there: go back to before it came in there.</source>
        <translation>La barrière à {place} mm traverse une surface déjà présente : revenez avant qu’elle n’y soit entrée.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies over surface that is already there: go back to before it came in there, or let the surface move in both directions.</source>
        <translation>La barrière à {place} mm recouvre une surface déjà présente : revenez avant qu’elle n’y soit entrée, ou laissez la surface bouger dans les deux sens.</translation>
    </message>
    <message>
        <source>The object '{object}' lies over surface that is already there: go back to before it came in there.</source>
        <translation>L’objet « {object} » recouvre une surface déjà présente : revenez avant qu’elle n’y soit entrée.</translation>
    </message>
    <message>
        <source>The clicks have so little in common with the surface that it would begin anew, but a part of it is pinned: take the pins away first.</source>
        <translation>Les points ont si peu en commun avec la surface qu’elle recommencerait, mais une partie en est fixée : retirez d’abord les fixations.</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration} comes too late: the surface is at iteration {now}.</source>
        <translation>Le veto de l’itération {iteration} vient trop tard : la surface est à l’itération {now}.</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration} has nothing to forbid: no change of topology happens there.</source>
        <translation>Le veto de l’itération {iteration} n’a rien à interdire : la topologie n’y change pas.</translation>
    </message>
    <message>
        <source>The pin {pin} comes too late: the surface is at iteration {now}.</source>
        <translation>La fixation {pin} vient trop tard : la surface est à l’itération {now}.</translation>
    </message>
    <message>
        <source>The pin {pin} holds nothing: no vertex of the surface lies there at iteration {now}.</source>
        <translation>La fixation {pin} ne retient rien : à l’itération {now}, aucun sommet de la surface ne s’y trouve.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} comes too late: the surface is at iteration {now}.</source>
        <translation>La retouche de l’itération {iteration} vient trop tard : la surface est à l’itération {now}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} cannot be made: {cause}.</source>
        <translation>La retouche de l’itération {iteration} est impossible : {cause}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no tunnel at {place}.</source>
        <translation>La retouche de l’itération {iteration} ne trouve aucun tunnel à {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no component at {place}.</source>
        <translation>La retouche de l’itération {iteration} ne trouve aucune composante à {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds no cavity at {place}.</source>
        <translation>La retouche de l’itération {iteration} ne trouve aucune cavité à {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} cannot be made: no cap fits into the tunnel at {place}.</source>
        <translation>La retouche de l’itération {iteration} est impossible : aucun couvercle ne convient au tunnel à {place}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} finds nothing to remove: there is nothing beside that component.</source>
        <translation>La retouche de l’itération {iteration} ne trouve rien à retirer : il n’y a rien d’autre que cette composante.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration} would leave nothing of the surface.</source>
        <translation>La retouche de l’itération {iteration} ne laisserait rien de la surface.</translation>
    </message>
    <message>
        <source>The surface vanished after {iterations} iterations: the seeds are not in an object of that kind and range.</source>
        <translation>La surface a disparu après {iterations} itérations : les germes ne sont pas dans un objet de ce type et de cet intervalle.</translation>
    </message>
    <message>
        <source>at iteration {iteration} a limit of the topology holds: {cause}; step 4, Grow, asks whether it may happen</source>
        <translation>à l’itération {iteration}, une limite de la topologie retient : {cause} ; l’étape 4, Croître, demande si cela peut se produire</translation>
    </message>
    <message>
        <source>it would enclose a cavity of {ml:3g} ml at {place:1f}</source>
        <translation>elle enfermerait une cavité de {ml:3g} ml en {place:1f}</translation>
    </message>
    <message>
        <source>a part of {ml:3g} ml would come off at {place:1f}</source>
        <translation>une partie de {ml:3g} ml se détacherait en {place:1f}</translation>
    </message>
    <message>
        <source>its fronts would meet at {place:1f}</source>
        <translation>ses fronts se rencontreraient en {place:1f}</translation>
    </message>
    <message>
        <source>its fronts would meet at {place:1f} and make a tunnel {around_mm:3g} mm around</source>
        <translation>ses fronts se rencontreraient en {place:1f} et formeraient un tunnel de {around_mm:3g} mm de tour</translation>
    </message>
    <message>
        <source>a change of its topology ({event}) would happen at {place:1f}</source>
        <translation>sa topologie changerait ({event}) en {place:1f}</translation>
    </message>
    <message>
        <source>its voxels cannot be read: {cause}</source>
        <translation>ses voxels ne peuvent pas être lus : {cause}</translation>
    </message>
    <message>
        <source>no object can be grown here: {cause}</source>
        <translation>aucun objet ne peut croître ici : {cause}</translation>
    </message>
    <message>
        <source>the surface was still moving at the iteration limit</source>
        <translation>la surface bougeait encore à la limite d’itérations</translation>
    </message>
    <message>
        <source>the surface got stuck before it was at rest</source>
        <translation>la surface s’est bloquée avant d’être au repos</translation>
    </message>
    <message>
        <source>the surface rests, but parts that could not be mended would still move</source>
        <translation>la surface est au repos, mais des parties qui n’ont pas pu être corrigées bougeraient encore</translation>
    </message>
    <message>
        <source>its voxels cannot be read</source>
        <translation>ses voxels ne peuvent pas être lus</translation>
    </message>
    <message>
        <source>the surface vanished</source>
        <translation>la surface a disparu</translation>
    </message>
    <message>
        <source>the surface leaked: {cause}</source>
        <translation>la surface a fui : {cause}</translation>
    </message>
    <message>
        <source>the volume jumps from {from_ml:4g} ml in frame {from_frame} to {to_ml:4g} ml</source>
        <translation>le volume saute de {from_ml:4g} ml dans l’image {from_frame} à {to_ml:4g} ml</translation>
    </message>
    <message>
        <source>the topology changes from 1 component of genus {genus_before} to 1 component of genus {genus}</source>
        <translation>la topologie passe de 1 composante de genre {genus_before} à 1 composante de genre {genus}</translation>
    </message>
    <message>
        <source>the topology changes from 1 component of genus {genus_before} to {components} components of genus {genus}</source>
        <translation>la topologie passe de 1 composante de genre {genus_before} à {components} composantes de genre {genus}</translation>
    </message>
    <message>
        <source>the topology changes from {components_before} components of genus {genus_before} to 1 component of genus {genus}</source>
        <translation>la topologie passe de {components_before} composantes de genre {genus_before} à 1 composante de genre {genus}</translation>
    </message>
    <message>
        <source>the topology changes from {components_before} components of genus {genus_before} to {components} components of genus {genus}</source>
        <translation>la topologie passe de {components_before} composantes de genre {genus_before} à {components} composantes de genre {genus}</translation>
    </message>
    <message>
        <source>the topology was held at 1 place, the first at {place} mm</source>
        <translation>la topologie a été retenue à 1 endroit, à {place} mm</translation>
    </message>
    <message>
        <source>the topology was held at {places} places, the first at {place} mm</source>
        <translation>la topologie a été retenue à {places} endroits, le premier à {place} mm</translation>
    </message>
    <message>
        <source>another object is likelier there, but it fails ({cause}); candidate {candidate} was taken</source>
        <translation>un autre objet y est plus probable, mais il échoue ({cause}) ; le candidat {candidate} a été pris</translation>
    </message>
    <message>
        <source>this is a cine (2D images over time: {frames:0f} frames), not a volume; if its frames are slices in space, enter their spacing in step 1, Open</source>
        <translation>c’est un ciné (des images 2D au fil du temps : {frames:0f}), pas un volume ; si ses images sont des coupes dans l’espace, saisissez leur espacement à l’étape 1, Ouvrir</translation>
    </message>
    <message>
        <source>{file}: {cause}.</source>
        <translation>{file} : {cause}.</translation>
    </message>
    <message>
        <source>{file}: {cause}</source>
        <translation>{file} : {cause}</translation>
    </message>
    <message>
        <source>{file}: {cause} in line {line:0f}.</source>
        <translation>{file} : {cause}, à la ligne {line:0f}.</translation>
    </message>
    <message>
        <source>{file}: cannot be written: {cause}.</source>
        <translation>{file} ne peut pas être écrit : {cause}.</translation>
    </message>
    <message>
        <source>{file}: it holds no series {series}.</source>
        <translation>{file} : la série {series} n’y figure pas.</translation>
    </message>
    <message>
        <source>{file} cannot be a surface to begin with: it {cause}.</source>
        <translation>{file} ne peut pas être une surface de départ : {cause}.</translation>
    </message>
    <message>
        <source>{file} is not the file that the session began with: its SHA-256 differs.</source>
        <translation>{file} n’est pas le fichier par lequel la session a commencé : son SHA-256 diffère.</translation>
    </message>
    <message>
        <source>{file} is not the volume that the session was made from: its SHA-256 differs.</source>
        <translation>{file} n’est pas le volume à partir duquel la session a été faite : son SHA-256 diffère.</translation>
    </message>
    <message>
        <source>{file} is not the label map that the walls were made from: its SHA-256 differs.</source>
        <translation>{file} n’est pas la carte d’étiquettes dont viennent les barrières : son SHA-256 diffère.</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: it has {size} voxels, the volume has {volume}.</source>
        <translation>{file} ne peut pas servir de barrières : la carte a {size} voxels, le volume {volume}.</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: its spacing, origin or direction are not the volume's.</source>
        <translation>{file} ne peut pas servir de barrières : son espacement, son origine ou sa direction ne sont pas ceux du volume.</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: all of its voxels are 0.</source>
        <translation>{file} ne peut pas servir de barrières : tous ses voxels valent 0.</translation>
    </message>
    <message>
        <source>{file} holds no object: all of its voxels are 0.</source>
        <translation>{file} ne contient aucun objet : tous ses voxels valent 0.</translation>
    </message>
    <message>
        <source>{file} is hardly a label map: it has more than {most:0f} different values.</source>
        <translation>{file} n’est guère une carte d’étiquettes : il contient plus de {most:0f} valeurs différentes.</translation>
    </message>
    <message>
        <source>{file} does not belong to this volume: a surface in it ({object}) lies outside of it.</source>
        <translation>{file} n’appartient pas à ce volume : une surface qu’il contient ({object}) se trouve hors de celui-ci.</translation>
    </message>
    <message>
        <source>{file} is a folder, not a session.</source>
        <translation>{file} est un dossier, pas une session.</translation>
    </message>
    <message>
        <source>{file} cannot be opened: {cause}.</source>
        <translation>{file} ne peut pas être ouvert : {cause}.</translation>
    </message>
    <message>
        <source>{file} cannot be read.</source>
        <translation>{file} ne peut pas être lu.</translation>
    </message>
    <message>
        <source>{file} is not a JSON file.</source>
        <translation>{file} n’est pas un fichier JSON.</translation>
    </message>
    <message>
        <source>{file} is neither a session nor a report: {cause}</source>
        <translation>{file} n’est ni une session ni un rapport : {cause}</translation>
    </message>
    <message>
        <source>it holds no objects.</source>
        <translation>elle ne contient pas d’objets.</translation>
    </message>
    <message>
        <source>it has no seeds.</source>
        <translation>elle n’a pas de germes.</translation>
    </message>
    <message>
        <source>there is no such file</source>
        <translation>ce fichier n’existe pas</translation>
    </message>
    <message>
        <source>there is no such file or folder</source>
        <translation>ce fichier ou dossier n’existe pas</translation>
    </message>
    <message>
        <source>it is not a file</source>
        <translation>ce n’est pas un fichier</translation>
    </message>
    <message>
        <source>it is neither a file nor a folder</source>
        <translation>ce n’est ni un fichier ni un dossier</translation>
    </message>
    <message>
        <source>it cannot be opened (permission?)</source>
        <translation>il ne peut pas être ouvert (autorisation manquante ?)</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>il ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>it cannot be read</source>
        <translation>il ne peut pas être lu</translation>
    </message>
    <message>
        <source>it cannot be read to its end</source>
        <translation>il ne peut pas être lu jusqu’à la fin</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>the folder cannot be read</source>
        <translation>le dossier ne peut pas être lu</translation>
    </message>
    <message>
        <source>the folder cannot be read ({reason})</source>
        <translation>le dossier ne peut pas être lu ({reason})</translation>
    </message>
    <message>
        <source>there is not enough memory to read it</source>
        <translation>il n’y a pas assez de mémoire pour le lire</translation>
    </message>
    <message>
        <source>not enough memory to decompress it</source>
        <translation>pas assez de mémoire pour le décompresser</translation>
    </message>
    <message>
        <source>it is truncated or damaged</source>
        <translation>il est tronqué ou endommagé</translation>
    </message>
    <message>
        <source>it is truncated or damaged ({reason})</source>
        <translation>il est tronqué ou endommagé ({reason})</translation>
    </message>
    <message>
        <source>its {format} header cannot be read ({reason})</source>
        <translation>son en-tête {format} ne peut pas être lu ({reason})</translation>
    </message>
    <message>
        <source>it is truncated within its {format} header</source>
        <translation>il est tronqué dans son en-tête {format}</translation>
    </message>
    <message>
        <source>its {format} header is truncated</source>
        <translation>son en-tête {format} est tronqué</translation>
    </message>
    <message>
        <source>its {format} header is truncated (no {field})</source>
        <translation>son en-tête {format} est tronqué ({field} manque)</translation>
    </message>
    <message>
        <source>its {format} header is damaged ({field})</source>
        <translation>son en-tête {format} est endommagé ({field})</translation>
    </message>
    <message>
        <source>the {format} file is damaged ({field})</source>
        <translation>le fichier {format} est endommagé ({field})</translation>
    </message>
    <message>
        <source>the {format} file is truncated</source>
        <translation>le fichier {format} est tronqué</translation>
    </message>
    <message>
        <source>it is not a {format} file</source>
        <translation>ce n’est pas un fichier {format}</translation>
    </message>
    <message>
        <source>it is not a volume in a known format (NIfTI, NRRD, MetaImage, DICOM, TIFF, GIPL)</source>
        <translation>ce n’est pas un volume dans un format connu (NIfTI, NRRD, MetaImage, DICOM, TIFF, GIPL)</translation>
    </message>
    <message>
        <source>this is a Git LFS pointer, not the file it stands for</source>
        <translation>c’est un pointeur Git LFS, pas le fichier qu’il représente</translation>
    </message>
    <message>
        <source>this is a compressed DICOM file; unpack it first (gunzip)</source>
        <translation>c’est un fichier DICOM compressé ; décompressez-le d’abord (gunzip)</translation>
    </message>
    <message>
        <source>this is a sequence of tracked 2D frames, not a volume; reconstruct a volume from it first</source>
        <translation>c’est une suite d’images 2D suivies, pas un volume ; reconstruisez-en d’abord un</translation>
    </message>
    <message>
        <source>this is a 2D image, a volume is needed</source>
        <translation>c’est une image 2D, il faut un volume</translation>
    </message>
    <message>
        <source>this is a 2D image, a volume needs at least two slices along each axis</source>
        <translation>c’est une image 2D, un volume a besoin d’au moins deux coupes le long de chaque axe</translation>
    </message>
    <message>
        <source>this looks like a 2D image in colour (its first axis has {values:0f} values, and the header says nothing of space)</source>
        <translation>cela ressemble à une image 2D en couleur (son premier axe a {values:0f} valeurs, et l’en-tête ne dit rien de l’espace)</translation>
    </message>
    <message>
        <source>the volume has no voxels (a size of 0)</source>
        <translation>le volume n’a pas de voxels (une taille de 0)</translation>
    </message>
    <message>
        <source>the volume has no voxels (a size of 0 in its header)</source>
        <translation>le volume n’a pas de voxels (une taille de 0 dans son en-tête)</translation>
    </message>
    <message>
        <source>its voxel spacing is zero, negative or not a number</source>
        <translation>son espacement des voxels est nul, négatif ou n’est pas un nombre</translation>
    </message>
    <message>
        <source>its position or its direction is not a number</source>
        <translation>sa position ou sa direction n’est pas un nombre</translation>
    </message>
    <message>
        <source>its axes are not at right angles (sheared or tilted), which is not supported</source>
        <translation>ses axes ne sont pas à angle droit (cisaillés ou inclinés), ce qui n’est pas pris en charge</translation>
    </message>
    <message>
        <source>it has no time points</source>
        <translation>il n’a aucun instant</translation>
    </message>
    <message>
        <source>the number of its time points is implausible ({frames:0f})</source>
        <translation>le nombre de ses instants n’est pas plausible ({frames:0f})</translation>
    </message>
    <message>
        <source>it declares {declared_gb:1f} GB of voxels, more than the {memory_gb:1f} GB of memory of this computer</source>
        <translation>il déclare {declared_gb:1f} Go de voxels, plus que les {memory_gb:1f} Go de mémoire de cet ordinateur</translation>
    </message>
    <message>
        <source>a size in its header is implausible ({size})</source>
        <translation>une taille dans son en-tête n’est pas plausible ({size})</translation>
    </message>
    <message>
        <source>its data file {data} is missing</source>
        <translation>son fichier de données {data} manque</translation>
    </message>
    <message>
        <source>it is truncated or damaged: the header declares {declared:0f} bytes of voxels, the file holds {held:0f}</source>
        <translation>il est tronqué ou endommagé : l’en-tête déclare {declared:0f} octets de voxels, le fichier en contient {held:0f}</translation>
    </message>
    <message>
        <source>it is truncated or damaged: the header declares {declared:0f} bytes of voxels, the file holds {held:0f} compressed</source>
        <translation>il est tronqué ou endommagé : l’en-tête déclare {declared:0f} octets de voxels, le fichier en contient {held:0f} compressés</translation>
    </message>
    <message>
        <source>its voxel data are truncated or damaged</source>
        <translation>ses données de voxels sont tronquées ou endommagées</translation>
    </message>
    <message>
        <source>the voxel data are truncated or damaged</source>
        <translation>les données de voxels sont tronquées ou endommagées</translation>
    </message>
    <message>
        <source>the compressed voxel data are truncated or damaged (checksum)</source>
        <translation>les données de voxels compressées sont tronquées ou endommagées (somme de contrôle)</translation>
    </message>
    <message>
        <source>1 of its voxels is infinite, the first at index ({index: 0f})</source>
        <translation>1 de ses voxels est infini, à l’indice ({index: 0f})</translation>
    </message>
    <message>
        <source>{voxels:0f} of its voxels are infinite, the first at index ({index: 0f})</source>
        <translation>{voxels:0f} de ses voxels sont infinis, le premier à l’indice ({index: 0f})</translation>
    </message>
    <message>
        <source>none of its voxels is a number</source>
        <translation>aucun de ses voxels n’est un nombre</translation>
    </message>
    <message>
        <source>its voxels have {components} components (vectors); only scalar and colour volumes are supported</source>
        <translation>ses voxels ont {components} composantes (vecteurs) ; seuls les volumes scalaires et en couleur sont pris en charge</translation>
    </message>
    <message>
        <source>it has more than four dimensions</source>
        <translation>il a plus de quatre dimensions</translation>
    </message>
    <message>
        <source>it has {dimensions:0f} dimensions; at most four are supported</source>
        <translation>il a {dimensions:0f} dimensions ; quatre au plus sont prises en charge</translation>
    </message>
    <message>
        <source>its voxel type ({type}) is not supported</source>
        <translation>son type de voxel ({type}) n’est pas pris en charge</translation>
    </message>
    <message>
        <source>its voxel type is not supported</source>
        <translation>son type de voxel n’est pas pris en charge</translation>
    </message>
    <message>
        <source>its NIfTI voxel type {type} is not supported</source>
        <translation>son type de voxel NIfTI {type} n’est pas pris en charge</translation>
    </message>
    <message>
        <source>it is not a NIfTI file, whatever its name says</source>
        <translation>ce n’est pas un fichier NIfTI, quoi qu’en dise son nom</translation>
    </message>
    <message>
        <source>this is an Analyze 7.5 file, whose orientation is not reliable; convert it to NIfTI</source>
        <translation>c’est un fichier Analyze 7.5, dont l’orientation n’est pas fiable ; convertissez-le en NIfTI</translation>
    </message>
    <message>
        <source>the sform in its header has an axis without length</source>
        <translation>la sform de son en-tête a un axe sans longueur</translation>
    </message>
    <message>
        <source>the sform in its header is not a number</source>
        <translation>la sform de son en-tête n’est pas un nombre</translation>
    </message>
    <message>
        <source>its list of data files ({pattern}) is not supported</source>
        <translation>sa liste de fichiers de données ({pattern}) n’est pas prise en charge</translation>
    </message>
    <message>
        <source>its encoding ({encoding}) is not supported; raw, gzip and ascii are</source>
        <translation>son codage ({encoding}) n’est pas pris en charge ; raw, gzip et ascii le sont</translation>
    </message>
    <message>
        <source>its data files do not divide its voxels evenly</source>
        <translation>ses fichiers de données ne divisent pas ses voxels en parts égales</translation>
    </message>
    <message>
        <source>its byte skip of -1 is not supported here</source>
        <translation>son saut d’octets de -1 n’est pas pris en charge ici</translation>
    </message>
    <message>
        <source>its voxels are not numbers ({word})</source>
        <translation>ses voxels ne sont pas des nombres ({word})</translation>
    </message>
    <message>
        <source>its voxels are spread over many data files, which is not supported</source>
        <translation>ses voxels sont répartis sur plusieurs fichiers de données, ce qui n’est pas pris en charge</translation>
    </message>
    <message>
        <source>its voxels are written as text, which is not supported</source>
        <translation>ses voxels sont écrits en texte, ce qui n’est pas pris en charge</translation>
    </message>
    <message>
        <source>it has {frames:0f} time points; of the volumes of a folder each is one time point</source>
        <translation>il a {frames:0f} instants ; chacun des volumes d’un dossier est un seul instant</translation>
    </message>
    <message>
        <source>its size, spacing or place is not the same as in {first}; the volumes of a folder are the time points of one</source>
        <translation>sa taille, son espacement ou sa position n’est pas comme dans {first} ; les volumes d’un dossier sont les instants d’un seul</translation>
    </message>
    <message>
        <source>its voxels are not of the same type and scale as in {first}; the volumes of a folder are the time points of one</source>
        <translation>ses voxels ne sont pas du même type et de la même échelle que dans {first} ; les volumes d’un dossier sont les instants d’un seul</translation>
    </message>
    <message>
        <source>it has {pages:0f} pages; of the TIFF files of a folder each is one slice</source>
        <translation>il a {pages:0f} pages ; parmi les fichiers TIFF d’un dossier, chacun est une coupe</translation>
    </message>
    <message>
        <source>its size, resolution or type of voxels is not the same as in {first}; the TIFF files of a folder are the slices of one volume</source>
        <translation>sa taille, sa résolution ou le type de ses voxels n’est pas le même que dans {first} ; les fichiers TIFF d’un dossier sont les coupes d’un même volume</translation>
    </message>
    <message>
        <source>it is no label map: it has voxels whose values are no whole numbers</source>
        <translation>ce n’est pas une carte d’étiquettes : des voxels ont des valeurs qui ne sont pas entières</translation>
    </message>
    <message>
        <source>the DICOM file is truncated or damaged</source>
        <translation>le fichier DICOM est tronqué ou endommagé</translation>
    </message>
    <message>
        <source>the file {part} is truncated or damaged</source>
        <translation>le fichier {part} est tronqué ou endommagé</translation>
    </message>
    <message>
        <source>the file {part} is truncated (cut off within its first 132 bytes)</source>
        <translation>le fichier {part} est tronqué (dans ses 132 premiers octets)</translation>
    </message>
    <message>
        <source>the file {part} is truncated (a slice without an image)</source>
        <translation>le fichier {part} est tronqué (une coupe sans image)</translation>
    </message>
    <message>
        <source>the DICOM header of {part} cannot be read ({reason})</source>
        <translation>l’en-tête DICOM de {part} ne peut pas être lu ({reason})</translation>
    </message>
    <message>
        <source>it is not a DICOM image (no rows and columns)</source>
        <translation>ce n’est pas une image DICOM (ni lignes ni colonnes)</translation>
    </message>
    <message>
        <source>the folder holds no DICOM images</source>
        <translation>le dossier ne contient pas d’images DICOM</translation>
    </message>
    <message>
        <source>the folder holds no DICOM images itself; open one of its subfolders</source>
        <translation>le dossier lui-même ne contient pas d’images DICOM ; ouvrez l’un de ses sous-dossiers</translation>
    </message>
    <message>
        <source>the slice {slice} does not say where it lies (position, orientation or pixel spacing)</source>
        <translation>la coupe {slice} ne dit pas où elle se trouve (position, orientation ou espacement des pixels)</translation>
    </message>
    <message>
        <source>the slice {slice} has a pixel spacing that is not positive</source>
        <translation>la coupe {slice} a un espacement des pixels qui n’est pas positif</translation>
    </message>
    <message>
        <source>the slice {slice} has directions that span no plane</source>
        <translation>la coupe {slice} a des directions qui n’engendrent pas de plan</translation>
    </message>
    <message>
        <source>the slice {slice} has no pixels</source>
        <translation>la coupe {slice} n’a pas de pixels</translation>
    </message>
    <message>
        <source>the slice {slice} cannot be opened</source>
        <translation>la coupe {slice} ne peut pas être ouverte</translation>
    </message>
    <message>
        <source>the slice {slice} cannot be read to its end</source>
        <translation>la coupe {slice} ne peut pas être lue jusqu’à la fin</translation>
    </message>
    <message>
        <source>the slice {slice} has another size than its header says</source>
        <translation>la coupe {slice} a une autre taille que ne le dit son en-tête</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged ({reason})</source>
        <translation>la coupe {slice} est tronquée ou endommagée ({reason})</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged (its pixels cannot be decoded)</source>
        <translation>la coupe {slice} est tronquée ou endommagée (ses pixels ne peuvent pas être décodés)</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged: it holds less pixels than its header says</source>
        <translation>la coupe {slice} est tronquée ou endommagée : elle contient moins de pixels que ne le dit son en-tête</translation>
    </message>
    <message>
        <source>the slice {slice} is truncated or damaged: its header declares {declared:0f} bytes of pixels, the file holds {held:0f} compressed</source>
        <translation>la coupe {slice} est tronquée ou endommagée : son en-tête déclare {declared:0f} octets de pixels, le fichier en contient {held:0f} compressés</translation>
    </message>
    <message>
        <source>the slice {slice} is damaged: a value is larger than its header allows</source>
        <translation>la coupe {slice} est endommagée : une valeur est plus grande que ne le permet son en-tête</translation>
    </message>
    <message>
        <source>its slices have different sizes</source>
        <translation>ses coupes ont des tailles différentes</translation>
    </message>
    <message>
        <source>its slices have different orientations</source>
        <translation>ses coupes ont des orientations différentes</translation>
    </message>
    <message>
        <source>its slices have different pixel spacings</source>
        <translation>ses coupes ont des espacements de pixels différents</translation>
    </message>
    <message>
        <source>its slices are partly in colour</source>
        <translation>une partie de ses coupes est en couleur</translation>
    </message>
    <message>
        <source>its slices are less than two pixels wide</source>
        <translation>ses coupes ont moins de deux pixels de large</translation>
    </message>
    <message>
        <source>several of its slices lie in the same place with different content, and not equally many in every place (time points or echoes that are not complete)</source>
        <translation>plusieurs de ses coupes se trouvent au même endroit avec un contenu différent, et leur nombre n’est pas partout le même (instants ou échos incomplets)</translation>
    </message>
    <message>
        <source>all its slices lie in the same place: 2D images over time, not a volume</source>
        <translation>toutes ses coupes se trouvent au même endroit : des images 2D au fil du temps, pas un volume</translation>
    </message>
    <message>
        <source>this is a single slice, a 2D image; give the folder with the whole series</source>
        <translation>c’est une seule coupe, une image 2D ; donnez le dossier contenant toute la série</translation>
    </message>
    <message>
        <source>its slices are shifted against each other by {shift_mm:4g} mm, more than they are apart; this is no gantry tilt</source>
        <translation>ses coupes sont décalées les unes par rapport aux autres de {shift_mm:4g} mm, plus que leur écart ; ce n’est pas une inclinaison du statif</translation>
    </message>
    <message>
        <source>{cause}, too unevenly to resample</source>
        <translation>{cause}, trop inégalement pour un rééchantillonnage</translation>
    </message>
    <message>
        <source>the number of frames in {slice} is implausible</source>
        <translation>le nombre d’images dans {slice} n’est pas plausible</translation>
    </message>
    <message>
        <source>pixels of {stored:0f} bits in {allocated:0f} are not supported ({slice})</source>
        <translation>les pixels de {stored:0f} bits dans {allocated:0f} ne sont pas pris en charge ({slice})</translation>
    </message>
    <message>
        <source>pixels with {samples:0f} samples are not supported ({slice})</source>
        <translation>les pixels à {samples:0f} échantillons ne sont pas pris en charge ({slice})</translation>
    </message>
    <message>
        <source>colour of {bits:0f} bits is not supported ({slice})</source>
        <translation>la couleur de {bits:0f} bits n’est pas prise en charge ({slice})</translation>
    </message>
    <message>
        <source>compressed pixels of one bit are not supported ({slice})</source>
        <translation>les pixels compressés d’un bit ne sont pas pris en charge ({slice})</translation>
    </message>
    <message>
        <source>the colour space {space} is not supported ({slice})</source>
        <translation>l’espace de couleurs {space} n’est pas pris en charge ({slice})</translation>
    </message>
    <message>
        <source>it does not say which segment each frame is of</source>
        <translation>il ne dit pas de quel segment est chaque image</translation>
    </message>
    <message>
        <source>it is a segmentation that is not binary ({bits:0f} bits per voxel), which is not supported</source>
        <translation>c’est une segmentation qui n’est pas binaire ({bits:0f} bits par voxel), ce qui n’est pas pris en charge</translation>
    </message>
    <message>
        <source>its pixels are compressed, which is not supported for a segmentation</source>
        <translation>ses pixels sont compressés, ce qui n’est pas pris en charge pour une segmentation</translation>
    </message>
    <message>
        <source>it is truncated or damaged: it holds less pixels than its header says</source>
        <translation>il est tronqué ou endommagé : il contient moins de pixels que ne le dit son en-tête</translation>
    </message>
    <message>
        <source>it does not say where every frame lies</source>
        <translation>il ne dit pas où se trouve chaque image</translation>
    </message>
    <message>
        <source>its frames do not lie one behind the other, which is not supported</source>
        <translation>ses images ne se suivent pas l’une derrière l’autre, ce qui n’est pas pris en charge</translation>
    </message>
    <message>
        <source>it does not give the distance between its slices</source>
        <translation>il ne donne pas la distance entre ses coupes</translation>
    </message>
    <message>
        <source>the distance of its frames is implausible</source>
        <translation>la distance de ses images n’est pas plausible</translation>
    </message>
    <message>
        <source>its frames are not evenly spaced</source>
        <translation>ses images ne sont pas régulièrement espacées</translation>
    </message>
    <message>
        <source>it cannot be read because the decoder {program} is not there</source>
        <translation>il ne peut pas être lu car le décodeur {program} est absent</translation>
    </message>
    <message>
        <source>the decoder cannot be started ({reason})</source>
        <translation>le décodeur ne peut pas être lancé ({reason})</translation>
    </message>
    <message>
        <source>the decoder {program} cannot be started ({reason})</source>
        <translation>le décodeur {program} ne peut pas être lancé ({reason})</translation>
    </message>
    <message>
        <source>the decoder broke down on it ({how}); the file is damaged or too large for it</source>
        <translation>le décodeur s’est arrêté dessus ({how}) ; le fichier est endommagé ou trop grand pour lui</translation>
    </message>
    <message>
        <source>the decoder broke down on {part} ({how}); the file is damaged or too large for it</source>
        <translation>le décodeur s’est arrêté sur {part} ({how}) ; le fichier est endommagé ou trop grand pour lui</translation>
    </message>
    <message>
        <source>the decoder got stuck on it and was stopped; the file is damaged</source>
        <translation>le décodeur s’est bloqué dessus et a été arrêté ; le fichier est endommagé</translation>
    </message>
    <message>
        <source>the decoder got stuck on {part} and was stopped; the file is damaged</source>
        <translation>le décodeur s’est bloqué sur {part} et a été arrêté ; le fichier est endommagé</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning</source>
        <translation>le décodeur a donné une réponse dénuée de sens</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning on it</source>
        <translation>le décodeur a donné une réponse dénuée de sens à son sujet</translation>
    </message>
    <message>
        <source>the decoder gave an answer without meaning on {part}</source>
        <translation>le décodeur a donné une réponse dénuée de sens sur {part}</translation>
    </message>
    <message>
        <source>the decoder gave less than it announced</source>
        <translation>le décodeur a donné moins qu’annoncé</translation>
    </message>
    <message>
        <source>decoding it takes more memory than its size allows</source>
        <translation>son décodage prend plus de mémoire que sa taille ne le permet</translation>
    </message>
    <message>
        <source>its data cannot be decoded ({reason})</source>
        <translation>ses données ne peuvent pas être décodées ({reason})</translation>
    </message>
    <message>
        <source>the mesh file is truncated or damaged</source>
        <translation>le fichier de maillage est tronqué ou endommagé</translation>
    </message>
    <message>
        <source>it is not an STL file, or it is truncated</source>
        <translation>ce n’est pas un fichier STL, ou il est tronqué</translation>
    </message>
    <message>
        <source>triangle strips are not supported</source>
        <translation>les bandes de triangles ne sont pas prises en charge</translation>
    </message>
    <message>
        <source>it holds no triangles</source>
        <translation>il ne contient pas de triangles</translation>
    </message>
    <message>
        <source>a coordinate is not a number or infinite</source>
        <translation>une coordonnée n’est pas un nombre ou est infinie</translation>
    </message>
    <message>
        <source>a face names a vertex that is not there</source>
        <translation>une face nomme un sommet qui n’existe pas</translation>
    </message>
    <message>
        <source>a face has less than three corners</source>
        <translation>une face a moins de trois sommets</translation>
    </message>
    <message>
        <source>a face is damaged</source>
        <translation>une face est endommagée</translation>
    </message>
    <message>
        <source>a vertex is not three numbers</source>
        <translation>un sommet n’est pas formé de trois nombres</translation>
    </message>
    <message>
        <source>its triangles have no area</source>
        <translation>ses triangles n’ont pas d’aire</translation>
    </message>
    <message>
        <source>has no triangles</source>
        <translation>elle n’a pas de triangles</translation>
    </message>
    <message>
        <source>is not closed</source>
        <translation>elle n’est pas fermée</translation>
    </message>
    <message>
        <source>is not manifold</source>
        <translation>elle n’est pas une variété</translation>
    </message>
    <message>
        <source>has faces that are not oriented alike</source>
        <translation>elle a des faces qui ne sont pas orientées de la même façon</translation>
    </message>
    <message>
        <source>intersects itself ({pairs:0f} pairs of faces)</source>
        <translation>elle se coupe elle-même ({pairs:0f} paires de faces)</translation>
    </message>
    <message>
        <source>intersects itself in single precision</source>
        <translation>elle se coupe elle-même en simple précision</translation>
    </message>
    <message>
        <source>has components that lie where they bound nothing</source>
        <translation>elle a des composantes situées là où elles ne délimitent rien</translation>
    </message>
    <message>
        <source>encloses no volume</source>
        <translation>elle n’entoure aucun volume</translation>
    </message>
    <message>
        <source>has no voxel of the value {label:0f}</source>
        <translation>aucun voxel n’a la valeur {label:0f}</translation>
    </message>
    <message>
        <source>has no voxel that is not 0</source>
        <translation>aucun voxel n’est différent de 0</translation>
    </message>
    <message>
        <source>is a mesh, which has no labels</source>
        <translation>c’est un maillage, qui n’a pas d’étiquettes</translation>
    </message>
    <message>
        <source>became surfaces without the label {label:0f}</source>
        <translation>l’étiquette {label:0f} a disparu en devenant des surfaces</translation>
    </message>
    <message>
        <source>has labels that lie in each other so finely that their surfaces cannot be kept apart</source>
        <translation>ses étiquettes sont si finement imbriquées que leurs surfaces ne peuvent pas être séparées</translation>
    </message>
    <message>
        <source>has a surface of more than {most:0f} triangles</source>
        <translation>sa surface aurait plus de {most:0f} triangles</translation>
    </message>
    <message>
        <source>it is a folder, not a file name</source>
        <translation>c’est un dossier, pas un nom de fichier</translation>
    </message>
    <message>
        <source>a folder has this name</source>
        <translation>un dossier porte ce nom</translation>
    </message>
    <message>
        <source>the data did not reach the disk (is it full?)</source>
        <translation>les données ne sont pas arrivées sur le disque (est-il plein ?)</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>le disque est peut-être plein</translation>
    </message>
    <message>
        <source>the file cannot be opened</source>
        <translation>le fichier ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>NIfTI cannot hold more than 32767 voxels or frames along an axis</source>
        <translation>NIfTI ne peut pas contenir plus de 32767 voxels ou images le long d’un axe</translation>
    </message>
    <message>
        <source>the mesh is too large for DICOM</source>
        <translation>le maillage est trop grand pour DICOM</translation>
    </message>
    <message>
        <source>it is too large for DICOM</source>
        <translation>c’est trop grand pour DICOM</translation>
    </message>
    <message>
        <source>the mesh is too large for 3MF</source>
        <translation>le maillage est trop grand pour 3MF</translation>
    </message>
    <message>
        <source>the object {object} holds the centre of no voxel</source>
        <translation>l’objet {object} ne contient le centre d’aucun voxel</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>autorisation refusée</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>il n’y a plus de place sur le disque</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>le système de fichiers est en lecture seule</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>aucun fichier ou dossier de ce nom</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>le nom de fichier est trop long</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>une partie du chemin n’est pas un dossier</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>le quota du disque est dépassé</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>erreur d’entrée-sortie</translation>
    </message>
    <message>
        <source>The pin at {place} mm lies outside of the volume.</source>
        <translation>La fixation à {place} mm se trouve hors du volume.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies outside of the volume.</source>
        <translation>La barrière à {place} mm se trouve hors du volume.</translation>
    </message>
    <message>
        <source>The wall disc at {place} mm lies outside of the volume.</source>
        <translation>Le disque barrière à {place} mm se trouve hors du volume.</translation>
    </message>
    <message>
        <source>The allowed place {place} lies outside of the volume.</source>
        <translation>L’endroit autorisé {place} se trouve hors du volume.</translation>
    </message>
    <message>
        <source>The place to hold {place} lies outside of the volume.</source>
        <translation>L’endroit à retenir {place} se trouve hors du volume.</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, lies outside of the volume.</source>
        <translation>La surface de départ, {file}, se trouve hors du volume.</translation>
    </message>
    <message>
        <source>The surface to begin with cannot become another one on the way: begin again.</source>
        <translation>La surface de départ ne peut pas en devenir une autre en chemin : recommencez.</translation>
    </message>
    <message>
        <source>The object '{object}' has no mesh that could be a wall.</source>
        <translation>L’objet « {object} » n’a pas de maillage qui puisse être une barrière.</translation>
    </message>
    <message>
        <source>The label map of the walls has not the volume's size.</source>
        <translation>La carte d’étiquettes des barrières n’a pas la taille du volume.</translation>
    </message>
    <message>
        <source>An allowed place has nothing to allow: the components and the genus have no limit.</source>
        <translation>Un endroit autorisé n’a rien à autoriser : les composantes et le genre n’ont pas de limite.</translation>
    </message>
    <message>
        <source>A place to hold has nothing to hold: the components and the genus have no limit.</source>
        <translation>Un endroit à retenir n’a rien à retenir : les composantes et le genre n’ont pas de limite.</translation>
    </message>
    <message>
        <source>There is nothing to ask about: the components and the genus have no limit.</source>
        <translation>Il n’y a rien à demander : les composantes et le genre n’ont pas de limite.</translation>
    </message>
    <message>
        <source>A pin cannot be set before the first step of a correction: make a step first.</source>
        <translation>Une fixation ne peut pas être posée avant le premier pas d’une correction : faites d’abord un pas.</translation>
    </message>
    <message>
        <source>The sensitivity cannot be told of a growth with vetoes, pins or edits: they name an iteration, and a perturbed run has others.</source>
        <translation>La sensibilité ne peut pas être indiquée pour une croissance avec des vetos, fixations ou modifications : elles nomment une itération, et une exécution perturbée en a d’autres.</translation>
    </message>
    <message>
        <source>The surface vanished.</source>
        <translation>La surface a disparu.</translation>
    </message>
    <message>
        <source>no DICOM file can be made: {cause}</source>
        <translation>aucun fichier DICOM ne peut être fait : {cause}</translation>
    </message>
    <message>
        <source>the volume was not read from DICOM, and a DICOM file belongs to a patient and a study</source>
        <translation>le volume n’a pas été lu depuis DICOM, et un fichier DICOM appartient à un patient et à une étude</translation>
    </message>
    <message>
        <source>the series does not say where its slices lie</source>
        <translation>la série ne dit pas où se trouvent ses coupes</translation>
    </message>
    <message>
        <source>its positions are in the frame of the ultrasound volume, not of the patient</source>
        <translation>ses positions se rapportent au volume échographique, pas au patient</translation>
    </message>
    <message>
        <source>its spacing was given by the user, not by the series</source>
        <translation>son espacement a été donné par l’utilisateur, pas par la série</translation>
    </message>
    <message>
        <source>'{text}' is longer than 64 bytes</source>
        <translation>« {text} » dépasse 64 octets</translation>
    </message>
    <message>
        <source>'{text}' holds a control character or a backslash</source>
        <translation>« {text} » contient un caractère de contrôle ou une barre oblique inverse</translation>
    </message>
    <message>
        <source>the label map is not on the grid of the series</source>
        <translation>la carte d’étiquettes n’est pas sur la grille de la série</translation>
    </message>
    <message>
        <source>tetrahedra are made by gmsh or TetGen, and neither program is installed (Debian's packages are gmsh and tetgen)</source>
        <translation>les tétraèdres sont faits par gmsh ou TetGen, et aucun des deux n’est installé (les paquets Debian sont gmsh et tetgen)</translation>
    </message>
    <message>
        <source>there are no tetrahedra of the object '{object}': {cause}.</source>
        <translation>il n’y a pas de tétraèdres de l’objet « {object} » : {cause}.</translation>
    </message>
    <message>
        <source>{file}: there is no frame {frame:0f}; it has the frames 0 to {last:0f}.</source>
        <translation>{file} : il n’y a pas d’image {frame:0f} ; il a les images 0 à {last:0f}.</translation>
    </message>
    <message>
        <source>{file}: there is no frame {frame:0f}; it has one frame, 0.</source>
        <translation>{file} : il n’y a pas d’image {frame:0f} ; il n’a qu’une image, 0.</translation>
    </message>
    <message>
        <source>the slice {slice} holds less frames than its header says</source>
        <translation>la coupe {slice} contient moins d’images que son en-tête n’en annonce</translation>
    </message>
    <message>
        <source>the palette of {slice} is missing or damaged</source>
        <translation>la palette de {slice} manque ou est endommagée</translation>
    </message>
    <message>
        <source>There are {frames:0f} time points; frame 0 is used (step 1, Open, chooses another).</source>
        <translation>Il y a {frames:0f} instants ; l’image 0 est utilisée (l’étape 1, Ouvrir, en choisit une autre).</translation>
    </message>
    <message>
        <source>The volume is uncalibrated: its file does not give the spacing, 1 mm is assumed where it is missing, and lengths and volumes mean nothing until it is entered in step 1, Open.</source>
        <translation>Le volume n’est pas calibré : son fichier ne donne pas l’espacement, 1 mm est supposé là où il manque, et longueurs et volumes ne signifient rien tant qu’il n’est pas saisi à l’étape 1, Ouvrir.</translation>
    </message>
    <message>
        <source>stack {stack:0f} ({slices:0f} slices)</source>
        <translation>pile {stack:0f} ({slices:0f} coupes)</translation>
    </message>
    <message>
        <source>it holds {series:0f} series or stacks, choose one in step 1, Open: {choices}</source>
        <translation>il contient {series:0f} séries ou piles, choisissez-en une à l’étape 1, Ouvrir : {choices}</translation>
    </message>
    <message>
        <source>No point of the lattice lies in A or B: there is no Dice coefficient.</source>
        <translation>Aucun point de la grille n’est dans A ou B : il n’y a pas de coefficient de Dice.</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list})</source>
        <translation>ses coupes sont inégalement espacées ({list})</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list}), 1 seems to be missing</source>
        <translation>ses coupes sont inégalement espacées ({list}), il semble en manquer 1</translation>
    </message>
    <message>
        <source>its slices are unevenly spaced ({list}), {missing:0f} seem to be missing</source>
        <translation>ses coupes sont inégalement espacées ({list}), il semble en manquer {missing:0f}</translation>
    </message>
    <message>
        <source>1 gap of {gap_mm:4g} mm</source>
        <translation>1 écart de {gap_mm:4g} mm</translation>
    </message>
    <message>
        <source>{gaps:0f} gaps of {gap_mm:4g} mm</source>
        <translation>{gaps:0f} écarts de {gap_mm:4g} mm</translation>
    </message>
    <message>
        <source>{gaps:0f} of {gap_mm:4g} mm</source>
        <translation>{gaps:0f} de {gap_mm:4g} mm</translation>
    </message>
    <message>
        <source>{gaps:0f} of {gap_mm:4g} mm …</source>
        <translation>{gaps:0f} de {gap_mm:4g} mm …</translation>
    </message>
    <message>
        <source>Colour was turned into luminance (0.2125 R + 0.7154 G + 0.0721 B).</source>
        <translation>La couleur a été convertie en luminance (0.2125 R + 0.7154 G + 0.0721 B).</translation>
    </message>
    <message>
        <source>The distance unit {unit} is taken as millimetres.</source>
        <translation>L’unité de distance {unit} est prise pour des millimètres.</translation>
    </message>
    <message>
        <source>The space units {units} are taken as millimetres.</source>
        <translation>Les unités d’espace {units} sont prises pour des millimètres.</translation>
    </message>
    <message>
        <source>The lengths in the header are in metres and were turned into millimetres.</source>
        <translation>Les longueurs de l’en-tête sont en mètres et ont été converties en millimètres.</translation>
    </message>
    <message>
        <source>The lengths in the header are in micrometres and were turned into millimetres.</source>
        <translation>Les longueurs de l’en-tête sont en micromètres et ont été converties en millimètres.</translation>
    </message>
    <message>
        <source>The header does not say how the volume lies in space (qform and sform codes are 0).</source>
        <translation>L’en-tête ne dit pas comment le volume est placé dans l’espace (les codes de qform et de sform sont 0).</translation>
    </message>
    <message>
        <source>The header does not say how the volume lies in space; its axes are taken as LPS.</source>
        <translation>L’en-tête ne dit pas comment le volume est placé dans l’espace ; ses axes sont pris comme LPS.</translation>
    </message>
    <message>
        <source>The sform and the qform of the header disagree (by up to {apart_mm:0f} mm); the qform is used.</source>
        <translation>La sform et la qform de l’en-tête se contredisent (de {apart_mm:0f} mm au plus) ; la qform est utilisée.</translation>
    </message>
    <message>
        <source>TIFF does not say how far apart the slices are nor how they lie; 1 mm and LPS axes are assumed.</source>
        <translation>TIFF ne dit ni l’écart entre les coupes ni leur placement ; 1 mm et des axes LPS sont supposés.</translation>
    </message>
    <message>
        <source>This is a segmentation: its voxels hold the numbers of the segments.</source>
        <translation>C’est une segmentation : ses voxels contiennent les numéros des segments.</translation>
    </message>
    <message>
        <source>The spacing was given by the user; the file says {x_mm:4g} mm, {y_mm:4g} mm, {z_mm:4g} mm.</source>
        <translation>L’espacement a été donné par l’utilisateur ; le fichier indique {x_mm:4g} mm, {y_mm:4g} mm, {z_mm:4g} mm.</translation>
    </message>
    <message>
        <source>{none:0f} of {voxels:0f} voxels are not a number: they count as outside of the field of view.</source>
        <translation>{none:0f} voxels sur {voxels:0f} ne sont pas un nombre : ils comptent comme hors du champ de vue.</translation>
    </message>
    <message>
        <source>1 slice is a copy of another and was left out.</source>
        <translation>1 coupe est la copie d’une autre et a été laissée de côté.</translation>
    </message>
    <message>
        <source>{copies:0f} slices are copies of others and were left out.</source>
        <translation>{copies:0f} coupes sont des copies d’autres et ont été laissées de côté.</translation>
    </message>
    <message>
        <source>The slices are tilted by {degrees:1f} degrees (gantry tilt) and were resampled to a straight grid.</source>
        <translation>Les coupes sont inclinées de {degrees:1f} degrés (inclinaison du statif) et ont été rééchantillonnées sur une grille droite.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}); they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>Les coupes sont inégalement espacées ({list}) ; elles ont été rééchantillonnées à un écart de {spacing_mm:4g} mm. Ce qui se trouve dans les intervalles est interpolé.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}), 1 seems to be missing; they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>Les coupes sont inégalement espacées ({list}), il semble en manquer 1 ; elles ont été rééchantillonnées à un écart de {spacing_mm:4g} mm. Ce qui se trouve dans les intervalles est interpolé.</translation>
    </message>
    <message>
        <source>The slices are unevenly spaced ({list}), {missing:0f} seem to be missing; they were resampled to a distance of {spacing_mm:4g} mm. What lies in the gaps is interpolated.</source>
        <translation>Les coupes sont inégalement espacées ({list}), il semble en manquer {missing:0f} ; elles ont été rééchantillonnées à un écart de {spacing_mm:4g} mm. Ce qui se trouve dans les intervalles est interpolé.</translation>
    </message>
    <message>
        <source>The header does not say where the slices lie; they are taken one behind the other, with LPS axes.</source>
        <translation>L’en-tête ne dit pas où se trouvent les coupes ; elles sont prises l’une derrière l’autre, avec des axes LPS.</translation>
    </message>
    <message>
        <source>The file does not say how the volume lies in the patient: columns are taken to run to the right, rows to the back and slices downwards.</source>
        <translation>Le fichier ne dit pas comment le volume est placé dans le patient : les colonnes sont supposées aller vers la droite, les lignes vers l’arrière et les coupes vers le bas.</translation>
    </message>
    <message>
        <source>The file breaks off: its header declares {frames:0f} time points, and only the first one is there in full.</source>
        <translation>Le fichier s’interrompt : son en-tête déclare {frames:0f} instants, et seul le premier est complet.</translation>
    </message>
    <message>
        <source>The file breaks off: its header declares {frames:0f} time points, and only the first {whole:0f} are there in full.</source>
        <translation>Le fichier s’interrompt : son en-tête déclare {frames:0f} instants, et seuls les {whole:0f} premiers sont complets.</translation>
    </message>
    <message>
        <source>1 file of DICOM in the folder is without an image and left out.</source>
        <translation>1 fichier DICOM du dossier est sans image et laissé de côté.</translation>
    </message>
    <message>
        <source>{files:0f} files of DICOM in the folder are without an image and left out.</source>
        <translation>{files:0f} fichiers DICOM du dossier sont sans image et laissés de côté.</translation>
    </message>
    <message>
        <source>1 file of other series is truncated or damaged.</source>
        <translation>1 fichier d’autres séries est tronqué ou endommagé.</translation>
    </message>
    <message>
        <source>{files:0f} files of other series are truncated or damaged.</source>
        <translation>{files:0f} fichiers d’autres séries sont tronqués ou endommagés.</translation>
    </message>
    <message>
        <source>1 file in the folder is not DICOM and left out: {names}.</source>
        <translation>1 fichier du dossier n’est pas DICOM et est laissé de côté : {names}.</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out: {names}.</source>
        <translation>{files:0f} fichiers du dossier ne sont pas DICOM et sont laissés de côté : {names}.</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out: {names} and {more:0f} more.</source>
        <translation>{files:0f} fichiers du dossier ne sont pas DICOM et sont laissés de côté : {names} et {more:0f} de plus.</translation>
    </message>
    <message>
        <source>1 file in the folder is not DICOM and left out.</source>
        <translation>1 fichier du dossier n’est pas DICOM et est laissé de côté.</translation>
    </message>
    <message>
        <source>{files:0f} files in the folder are not DICOM and left out.</source>
        <translation>{files:0f} fichiers du dossier ne sont pas DICOM et sont laissés de côté.</translation>
    </message>
    <message>
        <source>Its stacks of one pitch each are to be had alone: {list}.</source>
        <translation>Ses piles à un seul écart entre coupes peuvent s’ouvrir seules : {list}.</translation>
    </message>
    <message>
        <source>Its stacks of one pitch each are to be had alone.</source>
        <translation>Ses piles à un seul écart entre coupes peuvent s’ouvrir seules.</translation>
    </message>
    <message>
        <source>Nothing is chosen: {cause}.</source>
        <translation>Rien n’est choisi : {cause}.</translation>
    </message>
    <message>
        <source>{series} ({what}1 file, {size} voxels of {spacing_mm: 4g} mm)</source>
        <translation>{series} ({what}1 fichier, {size} voxels de {spacing_mm: 4g} mm)</translation>
    </message>
    <message>
        <source>{series} ({what}{files:0f} files, {size} voxels of {spacing_mm: 4g} mm)</source>
        <translation>{series} ({what}{files:0f} fichiers, {size} voxels de {spacing_mm: 4g} mm)</translation>
    </message>
    <message>
        <source>{series} ({what}1 file, no volume)</source>
        <translation>{series} ({what}1 fichier, pas de volume)</translation>
    </message>
    <message>
        <source>{series} ({what}{files:0f} files, no volume)</source>
        <translation>{series} ({what}{files:0f} fichiers, pas de volume)</translation>
    </message>
    <message>
        <source>{cause}.</source>
        <translation>{cause}.</translation>
    </message>
    <message>
        <source>{object}: {cause}</source>
        <translation>{object} : {cause}</translation>
    </message>
    <message>
        <source>{object} is empty: there are no distances.</source>
        <translation>{object} est vide : il n’y a pas de distances.</translation>
    </message>
    <message>
        <source>{object} is not closed: it has no volume, and there is no Dice coefficient. Distances are measured from and to what there is of its surface.</source>
        <translation>{object} n’est pas fermé : il n’a pas de volume, et il n’y a pas de coefficient de Dice. Les distances sont mesurées depuis et vers ce qui existe de sa surface.</translation>
    </message>
    <message>
        <source>{object} is closed, but not all of its faces are oriented alike: it has no volume, and there is no Dice coefficient.</source>
        <translation>{object} est fermé, mais toutes ses faces ne sont pas orientées de la même façon : il n’a pas de volume, et il n’y a pas de coefficient de Dice.</translation>
    </message>
    <message>
        <source>{object} is not a manifold: its genus and cavities cannot be counted.</source>
        <translation>{object} n’est pas une variété : son genre et ses cavités ne peuvent pas être comptés.</translation>
    </message>
    <message>
        <source>{object} is inside out; it was turned.</source>
        <translation>{object} est à l’envers ; il a été retourné.</translation>
    </message>
    <message>
        <source>A and B do not overlap: their surfaces are {apart_mm:4g} mm apart, the centres of their boxes {centres_mm:4g} mm.</source>
        <translation>A et B ne se recouvrent pas : leurs surfaces sont à {apart_mm:4g} mm l’une de l’autre, les centres de leurs boîtes à {centres_mm:4g} mm.</translation>
    </message>
    <message>
        <source>A and B do not overlap: their surfaces are {apart_mm:4g} mm apart, the centres of their boxes {centres_mm:4g} mm. With the signs of x and y turned in one of them they would meet: is one in RAS and does not say so?</source>
        <translation>A et B ne se recouvrent pas : leurs surfaces sont à {apart_mm:4g} mm l’une de l’autre, les centres de leurs boîtes à {centres_mm:4g} mm. Avec les signes de x et de y inversés dans l’un des deux, ils se rencontreraient : l’un est-il en RAS sans le dire ?</translation>
    </message>
    <message>
        <source>A part of the surface lies outside of the volume: intensities and label maps are of the rest.</source>
        <translation>Une partie de la surface est hors du volume : les intensités et les cartes d’étiquettes sont celles du reste.</translation>
    </message>
    <message>
        <source>{voxels:0f} voxels inside have no finite value and do not count.</source>
        <translation>{voxels:0f} voxels à l’intérieur n’ont pas de valeur finie et ne comptent pas.</translation>
    </message>
    <message>
        <source>No voxel with a value has its centre inside.</source>
        <translation>Aucun voxel ayant une valeur n’a son centre à l’intérieur.</translation>
    </message>
    <message>
        <source>“{object}” has no cavity, and so no wall around one.</source>
        <translation>« {object} » n’a pas de cavité, donc pas de paroi autour.</translation>
    </message>
    <message>
        <source>Positions are in the frame of the ultrasound volume, not of the patient: its axes are taken as LPS.</source>
        <translation>Les positions se rapportent au volume échographique, pas au patient : ses axes sont pris comme LPS.</translation>
    </message>
    <message>
        <source>MONOCHROME1: low values are bright on a display.</source>
        <translation>MONOCHROME1 : les valeurs basses sont claires à l’affichage.</translation>
    </message>
    <message>
        <source>The header scales voxels by 0, which would make them all alike; 1 is taken instead.</source>
        <translation>L’en-tête met les voxels à l’échelle par 0, ce qui les rendrait tous égaux ; 1 est pris à la place.</translation>
    </message>
    <message>
        <source>it holds several series or stacks, choose one in step 1, Open</source>
        <translation>il contient plusieurs séries ou piles, choisissez-en une à l’étape 1, Ouvrir</translation>
    </message>
    <message>
        <source>This session does not say where its volume is. Choose it.</source>
        <translation>Cette session ne dit pas où se trouve son volume. Choisissez-le.</translation>
    </message>
    <message>
        <source>This session does not say where the label map of its walls is. Choose it.</source>
        <translation>Cette session ne dit pas où se trouve la carte d’étiquettes de ses parois. Choisissez-la.</translation>
    </message>
    <message>
        <source>This session does not say where the file of a surface is that an object begins with. Choose it.</source>
        <translation>Cette session ne dit pas où se trouve le fichier d’une surface avec laquelle un objet commence. Choisissez-le.</translation>
    </message>
    <message>
        <source>{file}: series {series} is not the one that the session was made from: its voxels differ.</source>
        <translation>{file} : la série {series} n'est pas celle dont la session est issue : ses voxels diffèrent.</translation>
    </message>
    <message>
        <source>{file}: none of its series has the voxels that the session was made from.</source>
        <translation>{file} : aucune de ses séries n'a les voxels dont la session est issue.</translation>
    </message>
    <message>
        <source>the surface does not enclose the seed at {place:1f} mm, which lies {distance_mm:1f} mm outside of it: the image or other clicks speak against it</source>
        <translation>la surface n’entoure pas le germe en {place:1f} mm, situé à {distance_mm:1f} mm à l’extérieur : l’image ou d’autres points s’y opposent</translation>
    </message>
    <message>
        <source>the surface encloses the click outside of the object at {place:1f} mm, which lies {distance_mm:1f} mm within it: the image or other clicks speak against it</source>
        <translation>la surface entoure le point extérieur en {place:1f} mm, situé à {distance_mm:1f} mm à l’intérieur : l’image ou d’autres points s’y opposent</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm and the click outside of the object at {outside:1f} mm contradict each other: both lie in one voxel.</source>
        <translation>Le germe en {place:1f} mm et le point extérieur en {outside:1f} mm se contredisent : ils sont dans le même voxel.</translation>
    </message>
    <message>
        <source>the mesh is written as it was given: triangles with an angle under 15 degrees: {thin_faces:0f}, edges whose faces meet at less than 20 degrees: {sharp_edges:0f} (handlebody-cli edit --polish all betters them)</source>
        <translation>Le maillage est écrit tel qu'il a été donné : triangles ayant un angle de moins de 15 degrés : {thin_faces:0f}, arêtes dont les faces se rencontrent à moins de 20 degrés : {sharp_edges:0f} (handlebody-cli edit --polish all les améliore)</translation>
    </message>
    <message>
        <source>The segmentation has {layers:0f} layers, since segments overlap: only the segments of the first layer are read.</source>
        <translation>La segmentation a {layers:0f} couches, car des segments se chevauchent : seuls les segments de la première couche sont lus.</translation>
    </message>
    <message>
        <source>labels of the map that was given overlap: {voxels:0f} voxels of this one are left to smaller ones that hold them, too</source>
        <translation>des étiquettes de la carte donnée se recouvrent : {voxels:0f} voxels de celle-ci sont laissés à de plus petites qui les contiennent aussi</translation>
    </message>
    <message>
        <source>it has no label called '{name}'; it has: {names}</source>
        <translation>il n'a pas d'étiquette nommée « {name} » ; il a : {names}</translation>
    </message>
    <message>
        <source>it has no label called '{name}': it names none</source>
        <translation>il n'a pas d'étiquette nommée « {name} » : il n'en nomme aucune</translation>
    </message>
    <message>
        <source>it has several labels called '{name}': their number tells them apart</source>
        <translation>il a plusieurs étiquettes nommées « {name} » : leur numéro les distingue</translation>
    </message>
    <message>
        <source>has no voxel of the label {label:0f} that no smaller label holds, too</source>
        <translation>n'a aucun voxel de l'étiquette {label:0f} qu'une plus petite ne contienne aussi</translation>
    </message>
    <message>
        <source>has {tunnels:0f} tunnels, and no closing or opening leaves {most:0f} or fewer</source>
        <translation>a {tunnels:0f} tunnels, et aucune fermeture ni ouverture n'en laisse {most:0f} ou moins</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, meets the object '{object}', which comes before it. Labels of one map that touch are kept apart where they are opened together, with the same smoothing, largest part and tunnels.</source>
        <translation>La surface de départ, {file}, rencontre l’objet « {object} », qui vient avant elle. Les étiquettes d’une même carte qui se touchent sont tenues séparées si elles sont ouvertes ensemble, avec les mêmes réglages de lissage, de plus grande partie et de tunnels.</translation>
    </message>
    <message>
        <source>it is not a mesh file (.stl, .vtp, .ply, .obj, .3mf, .stl.dcm)</source>
        <translation>ce n’est pas un fichier de maillage (.stl, .vtp, .ply, .obj, .3mf, .stl.dcm)</translation>
    </message>
    <message>
        <source>it is encrypted</source>
        <translation>il est chiffré</translation>
    </message>
    <message>
        <source>it needs an extension of {format} that is not supported ({extension})</source>
        <translation>il lui faut une extension de {format} qui n’est pas prise en charge ({extension})</translation>
    </message>
    <message>
        <source>an object begins with one surface or is one, not both.</source>
        <translation>Un objet commence par une surface ou en est une, mais pas les deux.</translation>
    </message>
    <message>
        <source>The balloon weight must be a number above 0.</source>
        <translation>Le poids du ballon doit être un nombre supérieur à 0.</translation>
    </message>
    <message>
        <source>The curvature weight must be a number of at least 0.</source>
        <translation>Le poids de la courbure doit être un nombre supérieur ou égal à 0.</translation>
    </message>
    <message>
        <source>The number of iterations must not be negative.</source>
        <translation>Le nombre d’itérations ne doit pas être négatif.</translation>
    </message>
    <message>
        <source>The number of threads must be between 0 and 1024.</source>
        <translation>Le nombre de fils d’exécution doit être compris entre 0 et 1024.</translation>
    </message>
    <message>
        <source>The smoothing must be at least 0 mm.</source>
        <translation>Le lissage doit être d’au moins 0 mm.</translation>
    </message>
    <message>
        <source>The edge length must be above 0 mm.</source>
        <translation>La longueur d’arête doit être supérieure à 0 mm.</translation>
    </message>
    <message>
        <source>The smoothing of {given_mm} mm is too large for a volume whose longest side is {longest_mm} mm: at most {most_mm} mm.</source>
        <translation>Le lissage de {given_mm} mm est trop grand pour un volume dont le plus long côté mesure {longest_mm} mm : {most_mm} mm au plus.</translation>
    </message>
    <message>
        <source>The edge length of {given_mm} mm is too large for a volume whose longest side is {longest_mm} mm: at most {most_mm} mm.</source>
        <translation>La longueur d’arête de {given_mm} mm est trop grande pour un volume dont le plus long côté mesure {longest_mm} mm : {most_mm} mm au plus.</translation>
    </message>
    <message>
        <source>The number of components must be at least 1.</source>
        <translation>Le nombre de composantes doit être d’au moins 1.</translation>
    </message>
    <message>
        <source>The genus must be at least 0.</source>
        <translation>Le genre doit être d’au moins 0.</translation>
    </message>
    <message>
        <source>The wall at {place} has no radius above 0 mm.</source>
        <translation>La barrière à {place} n’a pas de rayon supérieur à 0 mm.</translation>
    </message>
    <message>
        <source>The wall disc at {place} has no radius above 0 mm.</source>
        <translation>Le disque barrière à {place} n’a pas de rayon supérieur à 0 mm.</translation>
    </message>
    <message>
        <source>The wall disc at {place} mm has a normal of no length.</source>
        <translation>Le disque barrière à {place} mm a une normale de longueur nulle.</translation>
    </message>
    <message>
        <source>The label map of the walls has not been read.</source>
        <translation>La carte d’étiquettes des barrières n’a pas été lue.</translation>
    </message>
    <message>
        <source>The surface to begin with, {file}, has not been read.</source>
        <translation>La surface de départ, {file}, n’a pas été lue.</translation>
    </message>
    <message>
        <source>A veto needs an iteration of at least 1 and a place.</source>
        <translation>Un veto exige une itération d’au moins 1 et un endroit.</translation>
    </message>
    <message>
        <source>Iteration {iteration:0f} is an edit: there is nothing that a veto could forbid.</source>
        <translation>L’itération {iteration:0f} est une retouche : il n’y a rien qu’un veto puisse interdire.</translation>
    </message>
    <message>
        <source>The pin at {place} has no radius above 0 mm.</source>
        <translation>La fixation à {place} n’a pas de rayon supérieur à 0 mm.</translation>
    </message>
    <message>
        <source>The pin at {place} mm has an iteration below 0.</source>
        <translation>La fixation à {place} mm a une itération inférieure à 0.</translation>
    </message>
    <message>
        <source>An edit needs an iteration of at least 1 and a place.</source>
        <translation>Une retouche exige une itération d’au moins 1 et un endroit.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a number that is not finite.</source>
        <translation>La retouche de l’itération {iteration:0f} a un nombre qui n’est pas fini.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has no radius above 0 mm.</source>
        <translation>La retouche de l’itération {iteration:0f} n’a pas de rayon supérieur à 0 mm.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a radius below 0 mm.</source>
        <translation>La retouche de l’itération {iteration:0f} a un rayon inférieur à 0 mm.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} has a normal of no length.</source>
        <translation>La retouche de l’itération {iteration:0f} a une normale de longueur nulle.</translation>
    </message>
    <message>
        <source>There are two edits of iteration {iteration:0f}: a step can be one only.</source>
        <translation>Il y a deux retouches de l’itération {iteration:0f} : un pas ne peut en être qu’une.</translation>
    </message>
    <message>
        <source>The veto of iteration {iteration:0f} has nothing to forbid: the growth ended at iteration {now:0f}.</source>
        <translation>Le veto de l’itération {iteration:0f} n’a rien à interdire : la croissance s’est terminée à l’itération {now:0f}.</translation>
    </message>
    <message>
        <source>The pin {pin} holds nothing: the growth ended at iteration {now:0f}.</source>
        <translation>La fixation {pin} ne retient rien : la croissance s’est terminée à l’itération {now:0f}.</translation>
    </message>
    <message>
        <source>The edit of iteration {iteration:0f} is never made: the growth ended at iteration {now:0f}.</source>
        <translation>La retouche de l’itération {iteration:0f} n’est jamais faite : la croissance s’est terminée à l’itération {now:0f}.</translation>
    </message>
    <message>
        <source>The surface intersects itself in single precision: the volume lies too far from the origin.</source>
        <translation>La surface s’intersecte elle-même en simple précision : le volume est trop loin de l’origine.</translation>
    </message>
    <message>
        <source>{sampling_mm:4g} mm between samples would take more than {most:0f} samples of these surfaces.</source>
        <translation>{sampling_mm:4g} mm entre les échantillons exigeraient plus de {most:0f} échantillons de ces surfaces.</translation>
    </message>
    <message>
        <source>{file}: it {cause}.</source>
        <translation>{file} : {cause}.</translation>
    </message>
    <message>
        <source>the {format} file is damaged ({cause})</source>
        <translation>le fichier {format} est endommagé ({cause})</translation>
    </message>
    <message>
        <source>{part} is missing</source>
        <translation>{part} manque</translation>
    </message>
    <message>
        <source>object {object:0f} is missing</source>
        <translation>l’objet {object:0f} manque</translation>
    </message>
    <message>
        <source>object {object:0f} holds itself</source>
        <translation>l’objet {object:0f} se contient lui-même</translation>
    </message>
    <message>
        <source>two objects {object:0f}</source>
        <translation>deux objets de numéro {object:0f}</translation>
    </message>
    <message>
        <source>an object without a number</source>
        <translation>un objet sans numéro</translation>
    </message>
    <message>
        <source>too deeply nested components</source>
        <translation>composants imbriqués trop profondément</translation>
    </message>
    <message>
        <source>more than {most:0f} objects and components</source>
        <translation>plus de {most:0f} objets et composants</translation>
    </message>
    <message>
        <source>a component or an item without an object</source>
        <translation>un composant ou un élément sans objet</translation>
    </message>
    <message>
        <source>a transform that is not twelve numbers</source>
        <translation>une transformation qui n’est pas faite de douze nombres</translation>
    </message>
    <message>
        <source>unit {unit}</source>
        <translation>unité {unit}</translation>
    </message>
    <message>
        <source>the compression of {part}</source>
        <translation>la compression de {part}</translation>
    </message>
    <message>
        <source>the size of {part}</source>
        <translation>la taille de {part}</translation>
    </message>
    <message>
        <source>{cause} in line {line:0f} of {part}</source>
        <translation>{cause} à la ligne {line:0f} de {part}</translation>
    </message>
    <message>
        <source>XML: {reason}</source>
        <translation>XML : {reason}</translation>
    </message>
    <message>
        <source>too deeply nested XML</source>
        <translation>XML imbriqué trop profondément</translation>
    </message>
    <message>
        <source>a document type declaration</source>
        <translation>une déclaration de type de document</translation>
    </message>
    <message>
        <source>a tag of more than a megabyte</source>
        <translation>une balise de plus d’un mégaoctet</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>une liste</translation>
    </message>
    <message>
        <source>it has no field '{field}'.</source>
        <translation>le champ « {field} » lui manque.</translation>
    </message>
    <message>
        <source>this version does not know its field '{field}'.</source>
        <translation>cette version ne connaît pas son champ « {field} ».</translation>
    </message>
    <message>
        <source>its field '{field}' is not a JSON object.</source>
        <translation>son champ « {field} » n’est pas un objet JSON.</translation>
    </message>
    <message>
        <source>its field '{field}' is not a list.</source>
        <translation>son champ « {field} » n’est pas une liste.</translation>
    </message>
    <message>
        <source>its field '{field}' must have {needed:0f} entries; it has {count:0f}.</source>
        <translation>son champ « {field} » doit avoir {needed:0f} éléments ; il en a {count:0f}.</translation>
    </message>
    <message>
        <source>its field '{field}' is not a text.</source>
        <translation>son champ « {field} » n’est pas un texte.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, neither true nor false.</source>
        <translation>son champ « {field} » est {value}, ni true ni false.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, not a number.</source>
        <translation>son champ « {field} » est {value}, qui n’est pas un nombre.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, not a whole number in range.</source>
        <translation>son champ « {field} » est {value}, qui n’est pas un nombre entier dans les limites.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be at least {least}.</source>
        <translation>son champ « {field} » est {value} et doit être d’au moins {least}.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be above {least}.</source>
        <translation>son champ « {field} » est {value} et doit être supérieur à {least}.</translation>
    </message>
    <message>
        <source>its field '{field}' is {value}, and must be from {least:0f} to {most:0f}.</source>
        <translation>son champ « {field} » est {value} et doit être compris entre {least:0f} et {most:0f}.</translation>
    </message>
    <message>
        <source>its field '{field}' is '{value}', a word that this version does not know.</source>
        <translation>son champ « {field} » est « {value} », un mot que cette version ne connaît pas.</translation>
    </message>
    <message>
        <source>its field '{field}' is empty.</source>
        <translation>son champ « {field} » est vide.</translation>
    </message>
    <message>
        <source>its field '{field}' is no range: its lower end is above its upper end.</source>
        <translation>son champ « {field} » n’est pas un intervalle : sa borne inférieure dépasse sa borne supérieure.</translation>
    </message>
    <message>
        <source>its field '{field}' is not above that of the entry before it.</source>
        <translation>son champ « {field} » n’est pas supérieur à celui de l’élément précédent.</translation>
    </message>
    <message>
        <source>its field '{field}' is 0, which is no label.</source>
        <translation>son champ « {field} » est 0, qui n’est pas une étiquette.</translation>
    </message>
    <message>
        <source>its field '{field}' is a vector of no length.</source>
        <translation>son champ « {field} » est un vecteur de longueur nulle.</translation>
    </message>
    <message>
        <source>its field '{field}' cannot name an object: a name has 1 to {most:0f} characters, no control characters and none of {separators}.</source>
        <translation>son champ « {field} » ne peut pas nommer un objet : un nom a de 1 à {most:0f} caractères, sans caractère de contrôle ni aucun de {separators}.</translation>
    </message>
    <message>
        <source>its field '{field}' has a code that is empty, too long, or holds what separates codes.</source>
        <translation>son champ « {field} » a un code vide, trop long ou qui contient ce qui sépare les codes.</translation>
    </message>
    <message>
        <source>its field '{field}' is a name that cannot be written into files.</source>
        <translation>son champ « {field} » est un nom qui ne peut pas être écrit dans des fichiers.</translation>
    </message>
    <message>
        <source>it holds a number that is too large.</source>
        <translation>elle contient un nombre trop grand.</translation>
    </message>
    <message>
        <source>several objects cannot be carried over time.</source>
        <translation>plusieurs objets ne peuvent pas être suivis dans le temps.</translation>
    </message>
    <message>
        <source>a corrected frame begins with the surface of the frame beside it, not with that of a file.</source>
        <translation>une image corrigée commence par la surface de l’image voisine, non par celle d’un fichier.</translation>
    </message>
    <message>
        <source>{file} holds {objects:0f} objects, where one is needed; handlebody-cli replay makes them all.</source>
        <translation>{file} contient {objects:0f} objets, là où il en faut un ; handlebody-cli replay les fait tous.</translation>
    </message>
    <message>
        <source>{file} is not needed: the session has no walls of a label map.</source>
        <translation>{file} n’est pas nécessaire : la session n’a pas de barrières d’une carte d’étiquettes.</translation>
    </message>
    <message>
        <source>{file} is not needed: nothing in the session begins with a surface.</source>
        <translation>{file} n’est pas nécessaire : rien dans la session ne commence par une surface.</translation>
    </message>
    <message>
        <source>{file}: the session does not keep which file is meant, so that only one can be; {other} is given, too.</source>
        <translation>{file} : la session ne retient pas quel fichier est visé, de sorte qu’il ne peut y en avoir qu’un ; {other} est donné aussi.</translation>
    </message>
    <message>
        <source>{file}: a series is chosen in DICOM alone, this is {format}.</source>
        <translation>{file} : on ne choisit une série que dans DICOM, ceci est {format}.</translation>
    </message>
    <message>
        <source>{file}: a spacing is not above 0.</source>
        <translation>{file} : un espacement n’est pas supérieur à 0.</translation>
    </message>
    <message>
        <source>{file}: meshes are written as .stl, .vtp, .ply or .obj.</source>
        <translation>{file} : les maillages sont écrits en .stl, .vtp, .ply ou .obj.</translation>
    </message>
    <message>
        <source>{file}: a mesh with values is written as .vtp.</source>
        <translation>{file} : un maillage avec des valeurs est écrit en .vtp.</translation>
    </message>
    <message>
        <source>{file}: volumes are written as .nii.gz, .nii, .nrrd or .mha.</source>
        <translation>{file} : les volumes sont écrits en .nii.gz, .nii, .nrrd ou .mha.</translation>
    </message>
    <message>
        <source>{file}: 4D volumes are written as .nii.gz, .nii or .nrrd.</source>
        <translation>{file} : les volumes 4D sont écrits en .nii.gz, .nii ou .nrrd.</translation>
    </message>
    <message>
        <source>a volume to be written needs at least two voxels along each axis</source>
        <translation>un volume à écrire a besoin d’au moins deux voxels le long de chaque axe</translation>
    </message>
    <message>
        <source>VTK wrote no scene of it</source>
        <translation>VTK n’en a pas écrit de scène</translation>
    </message>
    <message>
        <source>no folder for temporary files can be made: {cause}.</source>
        <translation>aucun dossier pour les fichiers temporaires ne peut être créé : {cause}.</translation>
    </message>
    <message>
        <source>what the clicks mean there agrees to {percent:0f} % (Dice) with the object of frame {from_frame} as the images move it; the latter was taken</source>
        <translation>ce que désignent les clics y concorde à {percent:0f} % (Dice) avec l’objet de l’image {from_frame} tel que les images le déplacent ; c’est ce dernier qui a été pris</translation>
    </message>
    <message>
        <source>what the clicks mean there fails ({cause}); the object of frame {from_frame} as the images move it was taken</source>
        <translation>ce que désignent les clics y échoue ({cause}) ; l’objet de l’image {from_frame} tel que les images le déplacent a été pris</translation>
    </message>
    <message>
        <source>it was carried from frame {from_frame}, whose surface failed</source>
        <translation>la surface vient de l’image {from_frame}, où elle a échoué</translation>
    </message>
    <message>
        <source>{file} cannot be used as walls: it has {frames:0f} time points, and walls are the same at all of them.</source>
        <translation>{file} ne peut pas servir de barrières : ce fichier a {frames:0f} instants, et les barrières sont les mêmes à tous.</translation>
    </message>
    <message>
        <source>There are {frames:0f} time points; the first one is used.</source>
        <translation>Il y a {frames:0f} instants ; le premier est utilisé.</translation>
    </message>
    <message>
        <source>The header does not say where the first voxel lies; it is taken to lie at 0, 0, 0.</source>
        <translation>L’en-tête ne dit pas où se trouve le premier voxel ; on suppose 0, 0, 0.</translation>
    </message>
    <message>
        <source>{object} has parts that lie where they bound nothing, as one does that is inside out: it has no volume, and there is no Dice coefficient.</source>
        <translation>{object} a des parties qui ne délimitent rien là où elles se trouvent, comme une partie retournée : pas de volume ni de coefficient de Dice.</translation>
    </message>
    <message>
        <source>The header does not state the distance of the slices: {spacing_mm:4g} mm are taken, the least between its frames, though a slice is {thickness_mm:4g} mm thick. Slices may be left out.</source>
        <translation>L’en-tête ne donne pas l’écart entre les coupes : on prend {spacing_mm:4g} mm, le plus petit entre ses images, alors qu’une coupe fait {thickness_mm:4g} mm d’épaisseur. Des coupes peuvent avoir été omises.</translation>
    </message>
    <message>
        <source>the veto of iteration {iteration:0f} forbids nothing: the mesh is that of iteration {mesh_iteration:0f}</source>
        <translation>le veto de l’itération {iteration:0f} n’interdit rien : le maillage est celui de l’itération {mesh_iteration:0f}</translation>
    </message>
    <message>
        <source>the edit of iteration {iteration:0f} is not made: the mesh is that of iteration {mesh_iteration:0f}</source>
        <translation>la modification de l’itération {iteration:0f} n’est pas faite : le maillage est celui de l’itération {mesh_iteration:0f}</translation>
    </message>
    <message>
        <source>The volume of the surface, {volume_ml:4g} ml, lies outside of those of all runs with clicks, smoothing and noise a little different, {least_ml:4g} to {most_ml:4g} ml: they may have found another object</source>
        <translation>Le volume de la surface, {volume_ml:4g} ml, se situe hors de ceux de toutes les répétitions avec des clics, un lissage et un bruit un peu différents, {least_ml:4g} à {most_ml:4g} ml : elles ont peut-être trouvé un autre objet</translation>
    </message>
    <message>
        <source>The sensitivity cannot be told of a surface that was given as it is: there is no growth to repeat.</source>
        <translation>La sensibilité d’une surface donnée telle quelle ne peut être indiquée : il n’y a pas de croissance à répéter.</translation>
    </message>
    <message>
        <source>the clicks may mean fewer objects than {asked:0f}, which is the one that was asked for: number {taken:0f}, the last of them, was taken</source>
        <translation>les clics peuvent désigner moins d’objets que {asked:0f}, le numéro demandé : le numéro {taken:0f}, le dernier d’entre eux, a été pris</translation>
    </message>
    <message>
        <source>The mesh encloses {mesh_ml:4g} ml, the voxels that it was made of {voxels_ml:4g} ml ({percent:0f} %): they are too few, or too narrow, for their shape to be kept.</source>
        <translation>Le maillage renferme {mesh_ml:4g} ml, les voxels dont il est issu {voxels_ml:4g} ml ({percent:0f} %) : ils sont trop peu nombreux ou trop étroits pour que leur forme soit conservée.</translation>
    </message>
    <message>
        <source>The edges of the mesh are {median_mm:3g} mm long in the median, not {asked_mm:4g} mm as was asked for: with such edges it would leave the voxels or intersect itself.</source>
        <translation>Les arêtes du maillage mesurent {median_mm:3g} mm en médiane, et non {asked_mm:4g} mm comme demandé : avec de telles arêtes, il quitterait les voxels ou se couperait lui-même.</translation>
    </message>
    <message>
        <source>the surface reaches {distance_mm:1f} mm into the ball of {radius_mm:1f} mm around the click outside of the object at {place:1f} mm: the image or other clicks speak against it</source>
        <translation>la surface pénètre de {distance_mm:1f} mm dans la boule de {radius_mm:1f} mm autour du point extérieur à {place:1f} mm : l’image ou d’autres clics s’y opposent</translation>
    </message>
    <message>
        <source>The seed at {place:1f} mm lies in the ball of {radius_mm:1f} mm around the click outside of the object at {outside:1f} mm: they contradict each other.</source>
        <translation>Le germe à {place:1f} mm se trouve dans la boule de {radius_mm:1f} mm autour du point extérieur à {outside:1f} mm : ils se contredisent.</translation>
    </message>
    <message>
        <source>The click outside of the object at {outside:1f} mm holds the deepest place of the surface to begin with, which stands for the object: give a seed, or another surface.</source>
        <translation>Le point extérieur à {outside:1f} mm contient le point le plus profond de la surface de départ, qui représente l’objet : donnez un germe ou une autre surface.</translation>
    </message>
    <message>
        <source>has no effect on an object that was given: its surface stays as it is, and nothing grows.</source>
        <translation>est sans effet sur un objet donné : sa surface reste telle quelle, et rien ne croît.</translation>
    </message>
    <message>
        <source>has no effect with a range, by which the intensities alone say what the object is: leave one of them out.</source>
        <translation>est sans effet avec une plage, où seules les intensités disent ce qu’est l’objet : omettez l’une des deux.</translation>
    </message>
    <message>
        <source>The wall at {place} mm lies over the surface that was given, or within it, and that surface stays as it is.</source>
        <translation>La paroi en {place} mm recouvre la surface donnée, ou se trouve dedans, et cette surface reste telle quelle.</translation>
    </message>
    <message>
        <source>object '{object}' has no seed and is left out.</source>
        <translation>l’objet « {object} » n’a pas de germe et est omis.</translation>
    </message>
    <message>
        <source>{session} was made by version {version}; this is {here}, and the mesh may differ.</source>
        <translation>{session} a été créé par la version {version} ; celle-ci est {here}, et le maillage peut différer.</translation>
    </message>
    <message>
        <source>the session carries the surface through other frames, too, and these figures are of frame {frame:0f} alone; handlebody-cli replay writes those of all.</source>
        <translation>la session porte la surface à travers d’autres images aussi, et ces chiffres sont de l’image {frame:0f} seule ; handlebody-cli replay écrit ceux de toutes.</translation>
    </message>
    <message>
        <source>has no effect: it says how a label becomes a surface, and {file} is a mesh.</source>
        <translation>est sans effet : cela dit comment une étiquette devient une surface, et {file} est un maillage.</translation>
    </message>
    <message>
        <source>{file} has {count:0f} components, and is to have no more than {most:0f}.</source>
        <translation>{file} a {count:0f} composantes et ne doit pas en avoir plus de {most:0f}.</translation>
    </message>
    <message>
        <source>{file} has {count:0f} handles or tunnels, and is to have no more than {most:0f}.</source>
        <translation>{file} a {count:0f} anses ou tunnels et ne doit pas en avoir plus de {most:0f}.</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source> More in the step Open.</source>
        <translation> Plus à l’étape Ouvrir.</translation>
    </message>
</context>
<context>
    <name>SliceView</name>
    <message>
        <source>Axial</source>
        <translation>Axiale</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronale</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittale</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>SurfaceView</name>
    <message>
        <source>%1 mm or more</source>
        <translation>%1 mm ou plus</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>outside: %1</source>
        <translation>dehors : %1</translation>
    </message>
    <message>
        <source>inside: %1</source>
        <translation>dedans : %1</translation>
    </message>
    <message>
        <source>on the reference: 0 mm</source>
        <translation>sur la référence : 0 mm</translation>
    </message>
</context>
<context>
    <name>handlebody::app::Screenshot</name>
    <message>
        <source>There is no seed to grow from: open a session.</source>
        <translation>Il n’y a pas de germe d’où grandir : ouvrez une session.</translation>
    </message>
    <message>
        <source>%1 cannot be written.</source>
        <translation>%1 ne peut pas être écrit.</translation>
    </message>
    <message>
        <source>There is no event at iteration %1, and so no stage of it.</source>
        <translation>Il n’y a pas d’événement à l’itération %1, et donc aucune de ses étapes.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>Il n’y a pas assez de mémoire pour cela.</translation>
    </message>
    <message>
        <source>Something went wrong that has no name.</source>
        <translation>Une erreur sans nom s’est produite.</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one first.</source>
        <translation>Il n’y a pas encore de surface : faites-en d’abord grandir une.</translation>
    </message>
    <message>
        <source>There is no centre line in “%1”: %2.</source>
        <translation>Il n’y a pas de ligne centrale dans « %1 » : %2.</translation>
    </message>
    <message>
        <source>The first place lies in none of the objects.</source>
        <translation>Le premier lieu n’est dans aucun des objets.</translation>
    </message>
    <message>
        <source>Slice %1 of %2</source>
        <translation>Coupe %1 sur %2</translation>
    </message>
    <message>
        <source>%1  %2  %3 mm</source>
        <translation>%1  %2  %3 mm</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>less than 1 %</source>
        <translation>moins de 1 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>not compared with the image</source>
        <translation>non comparé à l’image</translation>
    </message>
    <message>
        <source>not compared</source>
        <translation>non comparé</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>en mouvement</translation>
    </message>
    <message>
        <source>settled</source>
        <translation>au repos</translation>
    </message>
    <message>
        <source>new handle</source>
        <translation>nouvelle anse</translation>
    </message>
    <message>
        <source>colliding</source>
        <translation>en collision</translation>
    </message>
    <message>
        <source>no edge in the image: %1 of the surface</source>
        <translation>aucun contour dans l’image : %1 de la surface</translation>
    </message>
    <message>
        <source>edge in the image</source>
        <translation>contour dans l’image</translation>
    </message>
    <message>
        <source>no edge: %1</source>
        <translation>aucun contour : %1</translation>
    </message>
    <message>
        <source>border of the volume</source>
        <translation>bord du volume</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>fixé</translation>
    </message>
    <message>
        <source>colliding triangles</source>
        <translation>triangles en collision</translation>
    </message>
    <message>
        <source>vertices that are taken out</source>
        <translation>sommets retirés</translation>
    </message>
    <message>
        <source>boundary polygons</source>
        <translation>polygones de bord</translation>
    </message>
    <message>
        <source>handle</source>
        <translation>anse</translation>
    </message>
    <message>
        <source>closed mesh</source>
        <translation>maillage fermé</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius of the brush</source>
        <translation>Rayon du pinceau</translation>
    </message>
    <message>
        <source>The brush is a ball, the same for walls and for the surface; Ctrl+wheel changes it while it is on</source>
        <translation>Le pinceau est une boule, la même pour les barrières et pour la surface ; Ctrl+molette la change tant qu’il est actif</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Open file…</source>
        <translation>&amp;Ouvrir un fichier…</translation>
    </message>
    <message>
        <source>Open &amp;folder…</source>
        <translation>Ouvrir &amp;un dossier…</translation>
    </message>
    <message>
        <source>Open a folder with a DICOM series</source>
        <translation>Ouvrir un dossier contenant une série DICOM</translation>
    </message>
    <message>
        <source>&amp;Save session</source>
        <translation>Enregistrer la &amp;session</translation>
    </message>
    <message>
        <source>Save volume reference, seeds and parameters, to go on later or to replay</source>
        <translation>Enregistrer la référence du volume, les germes et les paramètres, pour continuer ou rejouer plus tard</translation>
    </message>
    <message>
        <source>Save session &amp;as…</source>
        <translation>&amp;Enregistrer la session sous…</translation>
    </message>
    <message>
        <source>Save the session under another name</source>
        <translation>Enregistrer la session sous un autre nom</translation>
    </message>
    <message>
        <source>&amp;Export result…</source>
        <translation>Exporter &amp;le résultat…</translation>
    </message>
    <message>
        <source>Write the surface or its label map to a file</source>
        <translation>Écrire la surface ou sa carte d’étiquettes dans un fichier</translation>
    </message>
    <message>
        <source>Export repor&amp;t…</source>
        <translation>Exporter le &amp;rapport…</translation>
    </message>
    <message>
        <source>Write parameters, numbers and events as JSON</source>
        <translation>Écrire paramètres, nombres et événements en JSON</translation>
    </message>
    <message>
        <source>Export &amp;picture…</source>
        <translation>Exporter une &amp;image…</translation>
    </message>
    <message>
        <source>Write what the views show as PNG</source>
        <translation>Écrire en PNG ce que montrent les vues</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Close the program</source>
        <translation>Fermer le programme</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Take back the last change</source>
        <translation>Annuler le dernier changement</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Do again what was taken back</source>
        <translation>Refaire ce qui a été annulé</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>&amp;Layout</source>
        <translation>&amp;Disposition</translation>
    </message>
    <message>
        <source>&amp;Step</source>
        <translation>É&amp;tape</translation>
    </message>
    <message>
        <source>3D &amp;camera</source>
        <translation>&amp;Caméra 3D</translation>
    </message>
    <message>
        <source>All &amp;four</source>
        <translation>&amp;Les quatre</translation>
    </message>
    <message>
        <source>Axial, 3D, coronal and sagittal view together</source>
        <translation>Vues axiale, 3D, coronale et sagittale ensemble</translation>
    </message>
    <message>
        <source>&amp;Axial only</source>
        <translation>&amp;Axiale seule</translation>
    </message>
    <message>
        <source>Only the axial slice</source>
        <translation>Seulement la coupe axiale</translation>
    </message>
    <message>
        <source>&amp;Coronal only</source>
        <translation>&amp;Coronale seule</translation>
    </message>
    <message>
        <source>Only the coronal slice</source>
        <translation>Seulement la coupe coronale</translation>
    </message>
    <message>
        <source>&amp;Sagittal only</source>
        <translation>&amp;Sagittale seule</translation>
    </message>
    <message>
        <source>Only the sagittal slice</source>
        <translation>Seulement la coupe sagittale</translation>
    </message>
    <message>
        <source>&amp;3D only</source>
        <translation>&amp;3D seule</translation>
    </message>
    <message>
        <source>Only the surface in 3D</source>
        <translation>Seulement la surface en 3D</translation>
    </message>
    <message>
        <source>1 &amp;Open</source>
        <translation>1 &amp;Ouvrir</translation>
    </message>
    <message>
        <source>Choose a volume</source>
        <translation>Choisir un volume</translation>
    </message>
    <message>
        <source>2 &amp;Seed</source>
        <translation>&amp;2 Germes</translation>
    </message>
    <message>
        <source>Place seeds in the object</source>
        <translation>Placer des germes dans l’objet</translation>
    </message>
    <message>
        <source>3 &amp;Tune</source>
        <translation>&amp;3 Régler</translation>
    </message>
    <message>
        <source>Set range and forces</source>
        <translation>Fixer l’intervalle et les forces</translation>
    </message>
    <message>
        <source>4 &amp;Grow</source>
        <translation>&amp;4 Croissance</translation>
    </message>
    <message>
        <source>Grow the surface and watch it</source>
        <translation>Faire grandir la surface et l’observer</translation>
    </message>
    <message>
        <source>5 &amp;Correct</source>
        <translation>5 &amp;Corriger</translation>
    </message>
    <message>
        <source>Walls, and what is held back: mend what has grown wrong</source>
        <translation>Barrières et ce qui est retenu : corriger ce qui a mal grandi</translation>
    </message>
    <message>
        <source>6 &amp;Export</source>
        <translation>6 &amp;Exporter</translation>
    </message>
    <message>
        <source>Write the results</source>
        <translation>Écrire les résultats</translation>
    </message>
    <message>
        <source>&amp;Reset views</source>
        <translation>&amp;Réinitialiser les vues</translation>
    </message>
    <message>
        <source>Whole slices, camera from the front</source>
        <translation>Coupes entières, caméra de face</translation>
    </message>
    <message>
        <source>From &amp;above (superior)</source>
        <translation>&amp;De dessus (supérieur)</translation>
    </message>
    <message>
        <source>3D view: look from superior; with the 3D view in focus</source>
        <translation>Vue 3D : regarder de dessus ; quand la vue 3D a le focus</translation>
    </message>
    <message>
        <source>From the &amp;front (anterior)</source>
        <translation>De &amp;face (antérieur)</translation>
    </message>
    <message>
        <source>3D view: look from anterior; with the 3D view in focus</source>
        <translation>Vue 3D : regarder de face ; quand la vue 3D a le focus</translation>
    </message>
    <message>
        <source>From the &amp;left</source>
        <translation>De &amp;gauche</translation>
    </message>
    <message>
        <source>3D view: look from the patient's left; with the 3D view in focus</source>
        <translation>Vue 3D : regarder de la gauche du patient ; quand la vue 3D a le focus</translation>
    </message>
    <message>
        <source>Slices &amp;in 3D</source>
        <translation>Coupes &amp;en 3D</translation>
    </message>
    <message>
        <source>Show the three slices in the 3D view</source>
        <translation>Montrer les trois coupes dans la vue 3D</translation>
    </message>
    <message>
        <source>Walls a&amp;nd pins</source>
        <translation>&amp;Barrières et fixations</translation>
    </message>
    <message>
        <source>Draw the active object's walls, and what of its surface is pinned</source>
        <translation>Dessiner les barrières de l’objet actif et ce qui est fixé de sa surface</translation>
    </message>
    <message>
        <source>CT pr&amp;esets</source>
        <translation>Préré&amp;glages CT</translation>
    </message>
    <message>
        <source>C&amp;olour map</source>
        <translation>Palette de c&amp;ouleurs</translation>
    </message>
    <message>
        <source>Sur&amp;face</source>
        <translation>&amp;Surface</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Apparence</translation>
    </message>
    <message>
        <source>Langua&amp;ge</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>Language of the texts and numbers in the window, from the next start on</source>
        <translation>Langue des textes et des nombres de la fenêtre, dès le prochain démarrage</translation>
    </message>
    <message>
        <source>&amp;Window and level by dragging</source>
        <translation>&amp;Fenêtre et niveau en glissant</translation>
    </message>
    <message>
        <source>Drag in a slice: sideways for the window (contrast), up and down for the level (brightness)</source>
        <translation>Glisser dans une coupe : sur le côté pour la fenêtre (contraste), verticalement pour le niveau (luminosité)</translation>
    </message>
    <message>
        <source>Au&amp;to window</source>
        <translation>Fe&amp;nêtre automatique</translation>
    </message>
    <message>
        <source>Window and level from the intensities of the volume</source>
        <translation>Fenêtre et niveau d’après les intensités du volume</translation>
    </message>
    <message>
        <source>&amp;Soft tissue (400 / 40 HU)</source>
        <translation>&amp;Tissus mous (400 / 40 HU)</translation>
    </message>
    <message>
        <source>Window 400, level 40</source>
        <translation>Fenêtre 400, niveau 40</translation>
    </message>
    <message>
        <source>&amp;Lung (1500 / −600 HU)</source>
        <translation>&amp;Poumon (1500 / −600 HU)</translation>
    </message>
    <message>
        <source>Window 1500, level −600</source>
        <translation>Fenêtre 1500, niveau −600</translation>
    </message>
    <message>
        <source>&amp;Bone (1800 / 400 HU)</source>
        <translation>&amp;Os (1800 / 400 HU)</translation>
    </message>
    <message>
        <source>Window 1800, level 400</source>
        <translation>Fenêtre 1800, niveau 400</translation>
    </message>
    <message>
        <source>B&amp;rain (80 / 40 HU)</source>
        <translation>&amp;Cerveau (80 / 40 HU)</translation>
    </message>
    <message>
        <source>Window 80, level 40</source>
        <translation>Fenêtre 80, niveau 40</translation>
    </message>
    <message>
        <source>&amp;Vessels (600 / 170 HU)</source>
        <translation>&amp;Vaisseaux (600 / 170 HU)</translation>
    </message>
    <message>
        <source>Window 600, level 170</source>
        <translation>Fenêtre 600, niveau 170</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Gris</translation>
    </message>
    <message>
        <source>Black to white</source>
        <translation>Du noir au blanc</translation>
    </message>
    <message>
        <source>&amp;Inverted</source>
        <translation>&amp;Inversée</translation>
    </message>
    <message>
        <source>White to black</source>
        <translation>Du blanc au noir</translation>
    </message>
    <message>
        <source>&amp;Hot</source>
        <translation>&amp;Chaude</translation>
    </message>
    <message>
        <source>Black over red and yellow to white</source>
        <translation>Du noir au blanc par le rouge et le jaune</translation>
    </message>
    <message>
        <source>&amp;Contrast-enhancing</source>
        <translation>Contraste &amp;renforcé</translation>
    </message>
    <message>
        <source>Dark intensities spread over many colours, for ultrasound</source>
        <translation>Intensités sombres étalées sur de nombreuses couleurs, pour l’échographie</translation>
    </message>
    <message>
        <source>&amp;Plain</source>
        <translation>&amp;Simple</translation>
    </message>
    <message>
        <source>One colour, shaded</source>
        <translation>Une seule couleur, ombrée</translation>
    </message>
    <message>
        <source>With &amp;edges</source>
        <translation>&amp;Avec les arêtes</translation>
    </message>
    <message>
        <source>The triangles' edges are drawn</source>
        <translation>Les arêtes des triangles sont dessinées</translation>
    </message>
    <message>
        <source>By &amp;state</source>
        <translation>Selon &amp;l’état</translation>
    </message>
    <message>
        <source>Moving, settled, new handle and colliding faces in their colours</source>
        <translation>Faces en mouvement, au repos, nouvelles et en collision dans leurs couleurs</translation>
    </message>
    <message>
        <source>Support by the &amp;image</source>
        <translation>Appui &amp;de l’image</translation>
    </message>
    <message>
        <source>Blue where the image shows no edge, in 3D and on the slices</source>
        <translation>Bleu là où l’image ne montre aucun contour, en 3D et sur les coupes</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>Comme le &amp;système</translation>
    </message>
    <message>
        <source>Light or dark as the desktop</source>
        <translation>Clair ou sombre comme le bureau</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>Dark text on light ground</source>
        <translation>Texte sombre sur fond clair</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>S&amp;ombre</translation>
    </message>
    <message>
        <source>Light text on dark ground</source>
        <translation>Texte clair sur fond sombre</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Ple&amp;in écran</translation>
    </message>
    <message>
        <source>The window fills the screen</source>
        <translation>La fenêtre remplit l’écran</translation>
    </message>
    <message>
        <source>&amp;Seed</source>
        <translation>&amp;Germe</translation>
    </message>
    <message>
        <source>&amp;Add at the crosshair</source>
        <translation>&amp;Ajouter au réticule</translation>
    </message>
    <message>
        <source>Place a seed where the crosshair is</source>
        <translation>Placer un germe au réticule</translation>
    </message>
    <message>
        <source>Add &amp;outside of the object</source>
        <translation>Ajouter &amp;hors de l’objet</translation>
    </message>
    <message>
        <source>Place a click outside of the object where the crosshair is</source>
        <translation>Placer un point extérieur au réticule</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Delete the selected seed or click outside</source>
        <translation>Supprimer le germe ou le point extérieur choisi</translation>
    </message>
    <message>
        <source>&amp;Larger radius</source>
        <translation>&amp;Rayon plus grand</translation>
    </message>
    <message>
        <source>Radius of the selected seed half a voxel larger</source>
        <translation>Rayon du germe choisi plus grand d’un demi-voxel</translation>
    </message>
    <message>
        <source>&amp;Smaller radius</source>
        <translation>Rayon &amp;plus petit</translation>
    </message>
    <message>
        <source>Radius of the selected seed half a voxel smaller</source>
        <translation>Rayon du germe choisi plus petit d’un demi-voxel</translation>
    </message>
    <message>
        <source>Select the &amp;next</source>
        <translation>&amp;Choisir le suivant</translation>
    </message>
    <message>
        <source>Select the next seed and move the crosshair there</source>
        <translation>Choisir le germe suivant et y placer le réticule</translation>
    </message>
    <message>
        <source>S&amp;maller object</source>
        <translation>&amp;Objet plus petit</translation>
    </message>
    <message>
        <source>Take the next smaller of the objects that the clicks may mean</source>
        <translation>Prendre le plus petit suivant des objets possibles</translation>
    </message>
    <message>
        <source>La&amp;rger object</source>
        <translation>Objet plus &amp;grand</translation>
    </message>
    <message>
        <source>Take the next larger of the objects that the clicks may mean</source>
        <translation>Prendre le plus grand suivant des objets possibles</translation>
    </message>
    <message>
        <source>&amp;Grow</source>
        <translation>&amp;Croissance</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Démarrer</translation>
    </message>
    <message>
        <source>Grow the surface, or pause</source>
        <translation>Faire grandir la surface, ou mettre en pause</translation>
    </message>
    <message>
        <source>One step &amp;forward</source>
        <translation>&amp;Un pas en avant</translation>
    </message>
    <message>
        <source>One iteration forward</source>
        <translation>Une itération en avant</translation>
    </message>
    <message>
        <source>One step &amp;back</source>
        <translation>Un &amp;pas en arrière</translation>
    </message>
    <message>
        <source>One iteration back, exactly</source>
        <translation>Une itération en arrière, exactement</translation>
    </message>
    <message>
        <source>&amp;Next event</source>
        <translation>Événement &amp;suivant</translation>
    </message>
    <message>
        <source>To the next change of topology; grows until there is one</source>
        <translation>Au prochain changement de topologie ; grandit jusqu’à ce qu’il y en ait un</translation>
    </message>
    <message>
        <source>&amp;Previous event</source>
        <translation>É&amp;vénement précédent</translation>
    </message>
    <message>
        <source>To the previous change of topology</source>
        <translation>Au changement de topologie précédent</translation>
    </message>
    <message>
        <source>Back to the s&amp;tart</source>
        <translation>&amp;Retour au début</translation>
    </message>
    <message>
        <source>To the seed spheres</source>
        <translation>Aux sphères des germes</translation>
    </message>
    <message>
        <source>To the &amp;last step</source>
        <translation>&amp;Au dernier pas</translation>
    </message>
    <message>
        <source>To the last iteration that was worked out</source>
        <translation>À la dernière itération calculée</translation>
    </message>
    <message>
        <source>&amp;Correct</source>
        <translation>C&amp;orriger</translation>
    </message>
    <message>
        <source>&amp;Paint walls</source>
        <translation>&amp;Peindre des barrières</translation>
    </message>
    <message>
        <source>Drag in a slice: the surface may not go where it is painted</source>
        <translation>Glisser dans une coupe : la surface ne peut aller là où c’est peint</translation>
    </message>
    <message>
        <source>&amp;Erase walls</source>
        <translation>&amp;Effacer des barrières</translation>
    </message>
    <message>
        <source>Drag in a slice: what the eraser touches is no wall any more</source>
        <translation>Glisser dans une coupe : ce que touche la gomme n’est plus une barrière</translation>
    </message>
    <message>
        <source>&amp;Larger brush</source>
        <translation>Pinceau plus &amp;grand</translation>
    </message>
    <message>
        <source>Radius of the brush a tenth larger</source>
        <translation>Rayon du pinceau plus grand d’un dixième</translation>
    </message>
    <message>
        <source>S&amp;maller brush</source>
        <translation>P&amp;inceau plus petit</translation>
    </message>
    <message>
        <source>Radius of the brush a tenth smaller</source>
        <translation>Rayon du pinceau plus petit d’un dixième</translation>
    </message>
    <message>
        <source>&amp;Wall at the crosshair</source>
        <translation>&amp;Barrière au réticule</translation>
    </message>
    <message>
        <source>A wall as large as the brush where the crosshair is</source>
        <translation>Une barrière de la taille du pinceau au réticule</translation>
    </message>
    <message>
        <source>E&amp;rase at the crosshair</source>
        <translation>Effacer au &amp;réticule</translation>
    </message>
    <message>
        <source>No walls where the eraser would touch them at the crosshair</source>
        <translation>Plus de barrières là où la gomme les touche au réticule</translation>
    </message>
    <message>
        <source>Go &amp;on from before the walls</source>
        <translation>Reprendre &amp;avant les barrières</translation>
    </message>
    <message>
        <source>Back to before the surface came to the new walls, and on from there</source>
        <translation>Revenir avant que la surface n’atteigne les nouvelles barrières, et continuer de là</translation>
    </message>
    <message>
        <source>Remo&amp;ve all walls</source>
        <translation>&amp;Supprimer toutes les barrières</translation>
    </message>
    <message>
        <source>Nothing that was painted is a wall any more</source>
        <translation>Rien de peint n’est plus une barrière</translation>
    </message>
    <message>
        <source>Pin &amp;by brush</source>
        <translation>&amp;Fixer au pinceau</translation>
    </message>
    <message>
        <source>Drag over the surface, in a slice or in 3D: what the brush covers stays as it is from the shown iteration on</source>
        <translation>Glisser sur la surface, dans une coupe ou en 3D : ce que couvre le pinceau reste tel quel à partir de l’itération montrée</translation>
    </message>
    <message>
        <source>Unp&amp;in by brush</source>
        <translation>Libérer au pi&amp;nceau</translation>
    </message>
    <message>
        <source>Drag over the surface, in a slice or in 3D: pins that the brush touches hold no more</source>
        <translation>Glisser sur la surface, dans une coupe ou en 3D : les fixations touchées par le pinceau ne tiennent plus</translation>
    </message>
    <message>
        <source>Smoot&amp;h by brush</source>
        <translation>Lisser a&amp;u pinceau</translation>
    </message>
    <message>
        <source>Click on the surface, in a slice or in 3D: it is smoothed under the brush, as the next step</source>
        <translation>Cliquer sur la surface, dans une coupe ou en 3D : elle est lissée sous le pinceau, au pas suivant</translation>
    </message>
    <message>
        <source>Pull by &amp;dragging</source>
        <translation>&amp;Tirer en glissant</translation>
    </message>
    <message>
        <source>Drag a point of the surface, in a slice or in 3D: it goes there, and what lies within the brush's radius less and less, as the next step</source>
        <translation>Tirer un point de la surface, dans une coupe ou en 3D : il y va, et ce qui est dans le rayon du pinceau de moins en moins, au pas suivant</translation>
    </message>
    <message>
        <source>Cut alon&amp;g a line</source>
        <translation>&amp;Couper le long d’une ligne</translation>
    </message>
    <message>
        <source>Draw a line across the surface in a slice: it is cut there at right angles to the slice, and closed on both sides, as the next step</source>
        <translation>Tracer une ligne à travers la surface dans une coupe : elle y est coupée perpendiculairement à la coupe et fermée des deux côtés, au pas suivant</translation>
    </message>
    <message>
        <source>Remove &amp;all pins</source>
        <translation>Suppri&amp;mer toutes les fixations</translation>
    </message>
    <message>
        <source>Nothing of the surface is pinned any more</source>
        <translation>Rien de la surface n’est plus fixé</translation>
    </message>
    <message>
        <source>Pi&amp;n here</source>
        <translation>Fi&amp;xer ici</translation>
    </message>
    <message>
        <source>The surface around the crosshair stays as it is from the shown iteration on</source>
        <translation>La surface autour du réticule reste telle quelle à partir de l’itération montrée</translation>
    </message>
    <message>
        <source>&amp;Smooth here</source>
        <translation>&amp;Lisser ici</translation>
    </message>
    <message>
        <source>Smooth the surface around its point nearest to the crosshair, as the next step</source>
        <translation>Lisser la surface autour de son point le plus proche du réticule, au pas suivant</translation>
    </message>
    <message>
        <source>P&amp;ull here</source>
        <translation>&amp;Tirer ici</translation>
    </message>
    <message>
        <source>Pull the point of the surface nearest to the crosshair there, as the next step</source>
        <translation>Y tirer le point de la surface le plus proche du réticule, au pas suivant</translation>
    </message>
    <message>
        <source>&amp;Cut here</source>
        <translation>C&amp;ouper ici</translation>
    </message>
    <message>
        <source>Cut along the chosen plane through the crosshair, as the next step</source>
        <translation>Couper selon le plan choisi par le réticule, au pas suivant</translation>
    </message>
    <message>
        <source>&amp;Objects</source>
        <translation>O&amp;bjets</translation>
    </message>
    <message>
        <source>&amp;Add object</source>
        <translation>&amp;Ajouter un objet</translation>
    </message>
    <message>
        <source>Another object in this volume; the surfaces before it are walls for it</source>
        <translation>Un autre objet dans ce volume ; les surfaces d’avant sont des barrières pour lui</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>&amp;Dupliquer</translation>
    </message>
    <message>
        <source>Another object with the same seeds and parameters</source>
        <translation>Un autre objet avec les mêmes germes et paramètres</translation>
    </message>
    <message>
        <source>D&amp;elete object</source>
        <translation>&amp;Supprimer l’objet</translation>
    </message>
    <message>
        <source>Delete the active object with its seeds and surface</source>
        <translation>Supprimer l’objet actif avec ses germes et sa surface</translation>
    </message>
    <message>
        <source>&amp;Properties…</source>
        <translation>&amp;Propriétés…</translation>
    </message>
    <message>
        <source>Name, colour, label value and term of the active object</source>
        <translation>Nom, couleur, valeur d’étiquette et terme de l’objet actif</translation>
    </message>
    <message>
        <source>Move &amp;up</source>
        <translation>&amp;Monter</translation>
    </message>
    <message>
        <source>The active object earlier in the list: what two claim belongs to the first</source>
        <translation>L’objet actif plus tôt dans la liste : ce que deux revendiquent appartient au premier</translation>
    </message>
    <message>
        <source>Move do&amp;wn</source>
        <translation>D&amp;escendre</translation>
    </message>
    <message>
        <source>The active object later in the list</source>
        <translation>L’objet actif plus loin dans la liste : ce que deux revendiquent appartient au premier</translation>
    </message>
    <message>
        <source>&amp;Next object</source>
        <translation>&amp;Objet suivant</translation>
    </message>
    <message>
        <source>The next object of the list is active</source>
        <translation>L’objet suivant de la liste devient actif</translation>
    </message>
    <message>
        <source>P&amp;revious object</source>
        <translation>Objet p&amp;récédent</translation>
    </message>
    <message>
        <source>The object before it in the list is active</source>
        <translation>L’objet précédent de la liste devient actif</translation>
    </message>
    <message>
        <source>&amp;Visible</source>
        <translation>&amp;Visible</translation>
    </message>
    <message>
        <source>Draw the surface of the active object</source>
        <translation>Dessiner la surface de l’objet actif</translation>
    </message>
    <message>
        <source>&amp;Locked</source>
        <translation>Verroui&amp;llé</translation>
    </message>
    <message>
        <source>Change nothing of the active object</source>
        <translation>Ne rien changer à l’objet actif</translation>
    </message>
    <message>
        <source>&amp;Grow all</source>
        <translation>Tout faire &amp;grandir</translation>
    </message>
    <message>
        <source>Grow all objects that are not done, in the order of the list</source>
        <translation>Faire grandir tous les objets non terminés, dans l’ordre de la liste</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mesurer</translation>
    </message>
    <message>
        <source>&amp;Measures</source>
        <translation>&amp;Mesures</translation>
    </message>
    <message>
        <source>Volume, area, diameters, intensities and distances of the objects, as a table</source>
        <translation>Volume, aire, diamètres, intensités et distances des objets, en tableau</translation>
    </message>
    <message>
        <source>&amp;Ruler</source>
        <translation>&amp;Règle</translation>
    </message>
    <message>
        <source>Click two points in the slices or on the surface: their distance in mm</source>
        <translation>Cliquer deux points dans les coupes ou sur la surface : leur distance en mm</translation>
    </message>
    <message>
        <source>&amp;Angle</source>
        <translation>&amp;Angle</translation>
    </message>
    <message>
        <source>Click three points, the second where the legs meet: the angle in degrees</source>
        <translation>Cliquer trois points, le deuxième là où les côtés se rejoignent : l’angle en degrés</translation>
    </message>
    <message>
        <source>&amp;Centre line</source>
        <translation>Ligne &amp;centrale</translation>
    </message>
    <message>
        <source>Click two places of an object: the line along its middle and the sections across it</source>
        <translation>Cliquer deux endroits d’un objet : la ligne en son milieu et les sections</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;ide</translation>
    </message>
    <message>
        <source>&amp;Guide</source>
        <translation>&amp;Guide</translation>
    </message>
    <message>
        <source>How to use the program</source>
        <translation>Comment utiliser le programme</translation>
    </message>
    <message>
        <source>&amp;Keyboard and mouse</source>
        <translation>&amp;Clavier et souris</translation>
    </message>
    <message>
        <source>All keys and mouse buttons</source>
        <translation>Toutes les touches et tous les boutons de la souris</translation>
    </message>
    <message>
        <source>&amp;About Handlebody</source>
        <translation>À &amp;propos de Handlebody</translation>
    </message>
    <message>
        <source>Version, purpose, licences</source>
        <translation>Version, but, licences</translation>
    </message>
    <message>
        <source>Dice</source>
        <translation>Dice</translation>
    </message>
    <message>
        <source>IoU</source>
        <translation>IoU</translation>
    </message>
    <message>
        <source>Mean distance of the surfaces, ASSD (mm)</source>
        <translation>Distance moyenne des surfaces, ASSD (mm)</translation>
    </message>
    <message>
        <source>95 % Hausdorff distance (mm)</source>
        <translation>Distance de Hausdorff à 95 % (mm)</translation>
    </message>
    <message>
        <source>Hausdorff distance (mm)</source>
        <translation>Distance de Hausdorff (mm)</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>Volume (ml)</translation>
    </message>
    <message>
        <source>Volume, difference (ml)</source>
        <translation>Volume, différence (ml)</translation>
    </message>
    <message>
        <source>Area (cm²)</source>
        <translation>Aire (cm²)</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Composantes</translation>
    </message>
    <message>
        <source>Tunnels</source>
        <translation>Tunnels</translation>
    </message>
    <message>
        <source>Cavities</source>
        <translation>Cavités</translation>
    </message>
    <message>
        <source> or </source>
        <translation> ou </translation>
    </message>
    <message>
        <source>Mouse and keys in a slice</source>
        <translation>Souris et touches dans une coupe</translation>
    </message>
    <message>
        <source>Left click</source>
        <translation>Clic gauche</translation>
    </message>
    <message>
        <source>Crosshair</source>
        <translation>Réticule</translation>
    </message>
    <message>
        <source>Return; with Shift</source>
        <translation>Entrée ; avec Maj</translation>
    </message>
    <message>
        <source>Seed at the crosshair; click outside of the object</source>
        <translation>Germe au réticule ; point extérieur</translation>
    </message>
    <message>
        <source>Left drag on a seed, on its rim</source>
        <translation>Glisser à gauche sur un germe, sur son bord</translation>
    </message>
    <message>
        <source>Move it, change its radius</source>
        <translation>Le déplacer, changer son rayon</translation>
    </message>
    <message>
        <source>Wheel; with Shift</source>
        <translation>Molette ; avec Maj</translation>
    </message>
    <message>
        <source>Next slice; five slices</source>
        <translation>Coupe suivante ; cinq coupes</translation>
    </message>
    <message>
        <source>Right drag, Ctrl+wheel</source>
        <translation>Glisser à droite, Ctrl+molette</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Middle drag, Shift+left drag</source>
        <translation>Glisser au milieu, Maj+glisser à gauche</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Déplacer</translation>
    </message>
    <message>
        <source>Arrows; with Shift</source>
        <translation>Flèches ; avec Maj</translation>
    </message>
    <message>
        <source>Crosshair by one voxel; by five</source>
        <translation>Réticule d’un voxel ; de cinq</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Page préc., Page suiv.</translation>
    </message>
    <message>
        <source>Next, previous slice</source>
        <translation>Coupe suivante, précédente</translation>
    </message>
    <message>
        <source>B or E, then left drag; Ctrl+wheel</source>
        <translation>B ou E, puis glisser à gauche ; Ctrl+molette</translation>
    </message>
    <message>
        <source>Paint or erase walls; radius of the brush</source>
        <translation>Peindre ou effacer des barrières ; rayon du pinceau</translation>
    </message>
    <message>
        <source>R, A or C, then clicks</source>
        <translation>R, A ou C, puis des clics</translation>
    </message>
    <message>
        <source>Ruler, angle, centre line: place points; Return: at the crosshair</source>
        <translation>Règle, angle, ligne centrale : placer des points ; Entrée : au réticule</translation>
    </message>
    <message>
        <source>Left drag on the end of a ruler or an angle</source>
        <translation>Glisser à gauche le bout d’une règle ou d’un angle</translation>
    </message>
    <message>
        <source>Move it</source>
        <translation>Le déplacer</translation>
    </message>
    <message>
        <source>L or Shift+L, then left drag</source>
        <translation>L ou Maj+L, puis glisser à gauche</translation>
    </message>
    <message>
        <source>Pin or unpin the surface under the brush</source>
        <translation>Fixer ou libérer la surface sous le pinceau</translation>
    </message>
    <message>
        <source>M, then left click</source>
        <translation>M, puis clic gauche</translation>
    </message>
    <message>
        <source>Smooth the surface under the brush</source>
        <translation>Lisser la surface sous le pinceau</translation>
    </message>
    <message>
        <source>U, then left drag from the outline</source>
        <translation>U, puis glisser à gauche depuis le contour</translation>
    </message>
    <message>
        <source>Pull the surface by that point</source>
        <translation>Tirer la surface par ce point</translation>
    </message>
    <message>
        <source>X, then left drag across the outline</source>
        <translation>X, puis glisser à gauche à travers le contour</translation>
    </message>
    <message>
        <source>Cut the surface along that line</source>
        <translation>Couper la surface le long de cette ligne</translation>
    </message>
    <message>
        <source>W, then left drag</source>
        <translation>W, puis glisser à gauche</translation>
    </message>
    <message>
        <source>Window (sideways) and level (up and down)</source>
        <translation>Fenêtre (sur le côté) et niveau (verticalement)</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Double clic</translation>
    </message>
    <message>
        <source>This view alone, or all four</source>
        <translation>Cette vue seule, ou les quatre</translation>
    </message>
    <message>
        <source>Mouse in the 3D view</source>
        <translation>Souris dans la vue 3D</translation>
    </message>
    <message>
        <source>Left drag</source>
        <translation>Glisser à gauche</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>Tourner</translation>
    </message>
    <message>
        <source>L, Shift+L, M or U, then left on the surface</source>
        <translation>L, Maj+L, M ou U, puis à gauche sur la surface</translation>
    </message>
    <message>
        <source>Pin, unpin, smooth, pull; beside it: rotate</source>
        <translation>Fixer, libérer, lisser, tirer ; à côté : tourner</translation>
    </message>
    <message>
        <source>R, A or C, then clicks on the surface</source>
        <translation>R, A ou C, puis des clics sur la surface</translation>
    </message>
    <message>
        <source>Ruler, angle, centre line: place points</source>
        <translation>Règle, angle, ligne centrale : placer des points</translation>
    </message>
    <message>
        <source>Right drag, wheel</source>
        <translation>Glisser à droite, molette</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Close the message over the views; else give up a stroke or a point, put brush and ruler away, leave window and level</source>
        <translation>Fermer le message au-dessus des vues ; sinon abandonner un trait ou un point, ranger pinceau et règle, quitter fenêtre et niveau</translation>
    </message>
    <message>
        <source>window</source>
        <translation>fenêtre</translation>
    </message>
    <message>
        <source>3D view, mesh files, pictures</source>
        <translation>vue 3D, fichiers de maillages, images</translation>
    </message>
    <message>
        <source>reading and writing volumes</source>
        <translation>lecture et écriture de volumes</translation>
    </message>
    <message>
        <source>linear algebra</source>
        <translation>algèbre linéaire</translation>
    </message>
    <message>
        <source>SHA-256 of volumes</source>
        <translation>SHA-256 des volumes</translation>
    </message>
    <message>
        <source>compressed files</source>
        <translation>fichiers compressés</translation>
    </message>
    <message>
        <source>sessions and reports</source>
        <translation>sessions et rapports</translation>
    </message>
    <message>
        <source>command line</source>
        <translation>ligne de commande</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Clavier et souris</translation>
    </message>
    <message>
        <source>Grows a certified surface from a point in a medical volume; the surface may change its topology on the way.</source>
        <translation>Fait grandir une surface certifiée à partir d’un point d’un volume médical ; sa topologie peut changer en chemin.</translation>
    </message>
    <message>
        <source>Apache License 2.0. The method is that of the paper “A Combinatorial Method for Topology Adaptations in 3D Deformable Models”.</source>
        <translation>Licence Apache 2.0. La méthode est celle de l’article « A Combinatorial Method for Topology Adaptations in 3D Deformable Models ».</translation>
    </message>
    <message>
        <source>Libraries</source>
        <translation>Bibliothèques</translation>
    </message>
    <message>
        <source>Qt is linked dynamically and can be replaced by another version of it.</source>
        <translation>Qt est lié dynamiquement et peut être remplacé par une autre version.</translation>
    </message>
    <message>
        <source>For research use only. Handlebody is not a medical device; do not use it for diagnosis or treatment.</source>
        <translation>Pour la recherche uniquement. Handlebody n’est pas un dispositif médical ; ne l’utilisez pas pour le diagnostic ni le traitement.</translation>
    </message>
    <message>
        <source>they meet</source>
        <translation>elles se rencontrent</translation>
    </message>
    <message>
        <source>%1, one within the other</source>
        <translation>%1, l’un dans l’autre</translation>
    </message>
    <message>
        <source>  from %1: mean %2, least %3, 95 % up to %4, largest %5</source>
        <translation>  de %1 : moyenne %2, minimum %3, 95 % jusqu’à %4, maximum %5</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Volume
(ml)</source>
        <translation>Volume
(ml)</translation>
    </message>
    <message>
        <source>Area
(cm²)</source>
        <translation>Aire
(cm²)</translation>
    </message>
    <message>
        <source>Largest
Ø (mm)</source>
        <translation>Plus grand
Ø (mm)</translation>
    </message>
    <message>
        <source>Intensity
mean ± SD</source>
        <translation>Intensité
moy. ± ET</translation>
    </message>
    <message>
        <source>Nearest object
(mm)</source>
        <translation>Objet le plus
proche (mm)</translation>
    </message>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Along its axes: %1 mm</source>
        <translation>Le long de ses axes : %1 mm</translation>
    </message>
    <message>
        <source>Along x, y, z: %1 mm</source>
        <translation>Le long de x, y, z : %1 mm</translation>
    </message>
    <message>
        <source>Largest Ø from %1 to %2</source>
        <translation>Plus grand Ø de %1 à %2</translation>
    </message>
    <message>
        <source>Centroid: %1 LPS</source>
        <translation>Centroïde : %1 LPS</translation>
    </message>
    <message>
        <source>Intensity %1 to %2, %3 voxels</source>
        <translation>Intensité de %1 à %2, %3 voxels</translation>
    </message>
    <message>
        <source>Components %1, cavities %2, tunnels %3</source>
        <translation>Composantes %1, cavités %2, tunnels %3</translation>
    </message>
    <message>
        <source>Distance to “%1”: %2</source>
        <translation>Distance à « %1 » : %2</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Épaisseur de paroi</translation>
    </message>
    <message>
        <source>Length %1, in “%2”</source>
        <translation>Longueur %1, dans « %2 »</translation>
    </message>
    <message>
        <source>Least section: %1</source>
        <translation>Plus petite section : %1</translation>
    </message>
    <message>
        <source>Largest: %1</source>
        <translation>Plus grande : %1</translation>
    </message>
    <message>
        <source>at %1: no section</source>
        <translation>à %1 : aucune section</translation>
    </message>
    <message>
        <source>at %1: %2 mm², Ø %3</source>
        <translation>à %1 : %2 mm², Ø %3</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ou&amp;verts récemment</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Panneaux</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Standard deviation of the Gaussian that smooths the image ahead. More for more speckle; 0 for none.</source>
        <translation>Écart type de la gaussienne qui lisse l’image au préalable. Plus pour plus de speckle ; 0 pour aucun.</translation>
    </message>
    <message>
        <source>Edge length</source>
        <translation>Longueur d’arête</translation>
    </message>
    <message>
        <source>Length that the edges of the mesh are kept near. Shorter shows finer detail and takes longer.</source>
        <translation>Longueur dont les arêtes du maillage restent proches. Plus court montre plus de détail et prend plus de temps.</translation>
    </message>
    <message>
        <source>Balloon</source>
        <translation>Ballon</translation>
    </message>
    <message>
        <source>Weight of the force that drives the surface outward. Less keeps it from leaking.</source>
        <translation>Poids de la force qui pousse la surface vers l’extérieur. Moins l’empêche de fuir.</translation>
    </message>
    <message>
        <source>Curvature</source>
        <translation>Courbure</translation>
    </message>
    <message>
        <source>Weight of smoothness. More closes narrow leaks and rounds the surface off.</source>
        <translation>Poids de la régularité. Plus ferme les fuites étroites et arrondit la surface.</translation>
    </message>
    <message>
        <source>Iteration limit</source>
        <translation>Limite d’itérations</translation>
    </message>
    <message>
        <source>The growth stops after so many iterations, finished or not.</source>
        <translation>La croissance s’arrête après ce nombre d’itérations, terminée ou non.</translation>
    </message>
    <message>
        <source>The file cannot be read.</source>
        <translation>Le fichier ne peut pas être lu.</translation>
    </message>
    <message>
        <source>The file cannot be written.</source>
        <translation>Le fichier ne peut pas être écrit.</translation>
    </message>
    <message>
        <source>Open a volume (NIfTI, NRRD, MetaImage, GIPL, TIFF, DICOM) or a session</source>
        <translation>Ouvrir un volume (NIfTI, NRRD, MetaImage, GIPL, TIFF, DICOM) ou une session</translation>
    </message>
    <message>
        <source>Open o&amp;bjects…</source>
        <translation>Ouvrir des o&amp;bjets…</translation>
    </message>
    <message>
        <source>Take surfaces of a mesh (STL, VTP, PLY, OBJ, 3MF) or a label map (DICOM, 3D Slicer, NIfTI, NRRD, MetaImage) as objects: as they are, or to grow from</source>
        <translation>Prendre comme objets les surfaces d’un maillage (STL, VTP, PLY, OBJ, 3MF) ou d’une carte d’étiquettes (DICOM, 3D Slicer, NIfTI, NRRD, MetaImage) : telles quelles, ou pour croître à partir d’elles</translation>
    </message>
    <message>
        <source>&amp;Time</source>
        <translation>&amp;Temps</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>Play the frames of the volume, or stop</source>
        <translation>Lire les images du volume, ou arrêter</translation>
    </message>
    <message>
        <source>P&amp;revious frame</source>
        <translation>Image p&amp;récédente</translation>
    </message>
    <message>
        <source>The frame before the shown one</source>
        <translation>L’image avant celle qui est affichée</translation>
    </message>
    <message>
        <source>&amp;Next frame</source>
        <translation>Image suiva&amp;nte</translation>
    </message>
    <message>
        <source>The frame after the shown one</source>
        <translation>L’image après celle qui est affichée</translation>
    </message>
    <message>
        <source>&amp;Back to where it is grown</source>
        <translation>Revenir à l’ima&amp;ge de croissance</translation>
    </message>
    <message>
        <source>The frame in which the surface is grown</source>
        <translation>L’image dans laquelle la surface croît</translation>
    </message>
    <message>
        <source>&amp;Grow in this frame</source>
        <translation>&amp;Croître dans cette image</translation>
    </message>
    <message>
        <source>Grow in the shown frame with the same clicks; what was grown in the other one is gone</source>
        <translation>Croître dans l’image affichée avec les mêmes points ; ce qui a crû dans l’autre disparaît</translation>
    </message>
    <message>
        <source>&amp;Over time</source>
        <translation>Au fil du t&amp;emps</translation>
    </message>
    <message>
        <source>Carry the surface from its frame through the others, both ways, in the background</source>
        <translation>Porter la surface de son image à travers les autres, dans les deux sens, en arrière-plan</translation>
    </message>
    <message>
        <source>&amp;Correct this frame</source>
        <translation>C&amp;orriger cette image</translation>
    </message>
    <message>
        <source>Change the surface of the shown frame with clicks, walls and edits, from that of the frame beside it on</source>
        <translation>Modifier la surface de l’image affichée avec des points, barrières et modifications, à partir de celle de l’image voisine</translation>
    </message>
    <message>
        <source>Carry on &amp;from here</source>
        <translation>Continuer à partir d’&amp;ici</translation>
    </message>
    <message>
        <source>The correction counts: the frames beyond this one are carried again from it</source>
        <translation>La correction compte : les images au-delà de celle-ci sont refaites à partir d’elle</translation>
    </message>
    <message>
        <source>&amp;Drop the correction</source>
        <translation>Aban&amp;donner la correction</translation>
    </message>
    <message>
        <source>Back to the frame that is grown; what was carried stays as it was</source>
        <translation>Retour à l’image de croissance ; ce qui a été porté reste inchangé</translation>
    </message>
    <message>
        <source>&amp;Volume over time</source>
        <translation>&amp;Volume au fil du temps</translation>
    </message>
    <message>
        <source>The volume of every frame, ejection fraction, and what went wrong in which frame</source>
        <translation>Le volume de chaque image, la fraction d’éjection et ce qui a échoué dans quelle image</translation>
    </message>
    <message>
        <source>Export &amp;meshes of all frames…</source>
        <translation>Exporter les &amp;maillages de toutes les images…</translation>
    </message>
    <message>
        <source>Write the surface of every frame, numbered, with a list for ParaView (.pvd) beside .vtp</source>
        <translation>Écrire la surface de chaque image, numérotée, avec une liste pour ParaView (.pvd) à côté des .vtp</translation>
    </message>
    <message>
        <source>Export 4D &amp;label map…</source>
        <translation>Exporter la carte d’étiq&amp;uettes 4D…</translation>
    </message>
    <message>
        <source>Write the surfaces of all frames as one label map with four dimensions</source>
        <translation>Écrire les surfaces de toutes les images en une carte d’étiquettes à quatre dimensions</translation>
    </message>
    <message>
        <source>&amp;Sensitivity</source>
        <translation>&amp;Sensibilité</translation>
    </message>
    <message>
        <source>Grow it again with clicks, smoothing and noise a little different: how much do volume and surface change?</source>
        <translation>Refaire croître avec des points, un lissage et un bruit un peu différents : de combien changent le volume et la surface ?</translation>
    </message>
    <message>
        <source>Export a&amp;nonymous session…</source>
        <translation>Exporter une session a&amp;nonyme…</translation>
    </message>
    <message>
        <source>Write a session that names neither the patient nor a file: it asks for its volume when it is opened</source>
        <translation>Écrit une session qui ne nomme ni le patient ni aucun fichier : à l’ouverture, elle demande son volume</translation>
    </message>
    <message>
        <source>the first point lies outside of the object</source>
        <translation>le premier point se trouve hors de l’objet</translation>
    </message>
    <message>
        <source>the second point lies outside of the object</source>
        <translation>le second point se trouve hors de l’objet</translation>
    </message>
    <message>
        <source>the two points lie in the same place of the object</source>
        <translation>les deux points se trouvent au même endroit de l’objet</translation>
    </message>
    <message>
        <source>the way between them is too long and thin to be searched</source>
        <translation>le chemin qui les relie est trop long et trop fin pour être exploré</translation>
    </message>
    <message>
        <source>there is no way from one to the other inside of the object</source>
        <translation>aucun chemin ne mène de l’un à l’autre à l’intérieur de l’objet</translation>
    </message>
    <message>
        <source>3MF files</source>
        <translation>fichiers 3MF</translation>
    </message>
    <message>
        <source>the outer surface</source>
        <translation>la surface extérieure</translation>
    </message>
    <message>
        <source>the cavities</source>
        <translation>les cavités</translation>
    </message>
    <message>
        <source>writing DICOM files</source>
        <translation>écriture de fichiers DICOM</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::CentreLinePage</name>
    <message>
        <source>The centre line</source>
        <translation>La ligne centrale</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Enregistrer en CSV…</translation>
    </message>
    <message>
        <source>Save as CSV</source>
        <translation>Enregistrer en CSV</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli measure --sections” writes</source>
        <translation>Le même tableau que celui qu’écrit « handlebody-cli measure --sections »</translation>
    </message>
    <message>
        <source>Save the sections</source>
        <translation>Enregistrer les sections</translation>
    </message>
    <message>
        <source>Between two places in an object, along its middle.</source>
        <translation>Entre deux endroits d’un objet, en son milieu.</translation>
    </message>
    <message>
        <source>Click in the object or on its surface where the line begins, or press Return for the crosshair.</source>
        <translation>Cliquez dans l’objet ou sur sa surface là où la ligne commence, ou appuyez sur Entrée pour le réticule.</translation>
    </message>
    <message>
        <source>Click where it ends. Escape takes the beginning back.</source>
        <translation>Cliquez là où elle finit. Échap annule le début.</translation>
    </message>
    <message>
        <source>Searching for the middle of the object…</source>
        <translation>Recherche du milieu de l’objet…</translation>
    </message>
    <message>
        <source>Pointed at: %1</source>
        <translation>Pointé : %1</translation>
    </message>
    <message>
        <source>It was made in an earlier surface.</source>
        <translation>Elle a été faite dans une surface antérieure.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Search no longer</source>
        <translation>Ne plus chercher</translation>
    </message>
    <message>
        <source>Draw the line no more</source>
        <translation>Ne plus dessiner la ligne</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Enregistrer en JSON…</translation>
    </message>
    <message>
        <source>Save as JSON</source>
        <translation>Enregistrer en JSON</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes of the line</source>
        <translation>Ce que « handlebody-cli measure --json » écrit de la ligne</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ComparePage</name>
    <message>
        <source>Figure</source>
        <translation>Indice</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <source>The object beside the reference</source>
        <translation>L’objet à côté de la référence</translation>
    </message>
    <message>
        <source>Save the comparison</source>
        <translation>Enregistrer la comparaison</translation>
    </message>
    <message>
        <source>Choose reference…</source>
        <translation>Choisir la référence…</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Compare the shown surface with the reference</source>
        <translation>Comparer la surface montrée à la référence</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Enregistrer en CSV…</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli compare --csv” writes</source>
        <translation>Le même tableau que celui qu’écrit « handlebody-cli compare --csv »</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Enregistrer en JSON…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli compare --report” writes</source>
        <translation>La même chose que ce qu’écrit « handlebody-cli compare --report »</translation>
    </message>
    <message>
        <source>The reference</source>
        <translation>La référence</translation>
    </message>
    <message>
        <source>State of the comparison</source>
        <translation>État de la comparaison</translation>
    </message>
    <message>
        <source>all but 0</source>
        <translation>tout sauf 0</translation>
    </message>
    <message>
        <source>Which voxels of a label map are the reference</source>
        <translation>Quels voxels d’une carte d’étiquettes sont la référence</translation>
    </message>
    <message>
        <source>Distances in colour on the surface</source>
        <translation>Distances en couleur sur la surface</translation>
    </message>
    <message>
        <source>Blue inside of the reference, red outside of it</source>
        <translation>Bleu dans la référence, rouge hors d’elle</translation>
    </message>
    <message>
        <source>The objects are compared</source>
        <translation>Les objets sont comparés</translation>
    </message>
    <message>
        <source>Choose the reference</source>
        <translation>Choisir la référence</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>No reference is chosen.</source>
        <translation>Aucune référence n’est choisie.</translation>
    </message>
    <message>
        <source>There is no surface to compare yet: grow one first.</source>
        <translation>Il n’y a pas encore de surface à comparer : faites-en d’abord grandir une.</translation>
    </message>
    <message>
        <source>Comparing…</source>
        <translation>Comparaison…</translation>
    </message>
    <message>
        <source>These are figures of an earlier surface, or of another object.</source>
        <translation>Ces indices sont ceux d’une surface antérieure ou d’un autre objet.</translation>
    </message>
    <message>
        <source>A mesh, a label map or another object to compare the active object with</source>
        <translation>Un maillage, une carte d’étiquettes ou un autre objet à comparer à l’objet actif</translation>
    </message>
    <message>
        <source>Save distances…</source>
        <translation>Enregistrer les distances…</translation>
    </message>
    <message>
        <source>The surface with its distance from the reference at every vertex, as “handlebody-cli compare -o” writes it</source>
        <translation>La surface avec sa distance à la référence en chaque sommet, comme l’écrit « handlebody-cli compare -o »</translation>
    </message>
    <message>
        <source>Why no labels are listed</source>
        <translation>Pourquoi aucune étiquette n’est listée</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>Étiquette</translation>
    </message>
    <message>
        <source>Label of the reference</source>
        <translation>Étiquette de la référence</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>D’un fichier…</translation>
    </message>
    <message>
        <source>Save the distances</source>
        <translation>Enregistrer les distances</translation>
    </message>
    <message>
        <source>Meshes and label maps (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;All files (*)</source>
        <translation>Maillages et cartes d’étiquettes (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::Document</name>
    <message>
        <source>“%1” is locked: unlock it to change it.</source>
        <translation>« %1 » est verrouillé : déverrouillez-le pour le modifier.</translation>
    </message>
    <message>
        <source>Add click outside</source>
        <translation>Ajouter un point extérieur</translation>
    </message>
    <message>
        <source>Add seed</source>
        <translation>Ajouter un germe</translation>
    </message>
    <message>
        <source>Delete click outside</source>
        <translation>Supprimer le point extérieur</translation>
    </message>
    <message>
        <source>Delete seed</source>
        <translation>Supprimer le germe</translation>
    </message>
    <message>
        <source>Move click outside</source>
        <translation>Déplacer le point extérieur</translation>
    </message>
    <message>
        <source>Move seed</source>
        <translation>Déplacer le germe</translation>
    </message>
    <message>
        <source>Change radius of click outside</source>
        <translation>Changer le rayon du point extérieur</translation>
    </message>
    <message>
        <source>Change seed radius</source>
        <translation>Changer le rayon du germe</translation>
    </message>
    <message>
        <source>Smaller object</source>
        <translation>Objet plus petit</translation>
    </message>
    <message>
        <source>Larger object</source>
        <translation>Objet plus grand</translation>
    </message>
    <message>
        <source>The wall would lie outside of the volume: it is not kept.</source>
        <translation>La barrière serait hors du volume : elle n’est pas gardée.</translation>
    </message>
    <message>
        <source>The wall would lie over the seed at %1 mm: it is not kept.</source>
        <translation>La barrière recouvrirait le germe à %1 mm : elle n’est pas gardée.</translation>
    </message>
    <message>
        <source>Paint wall</source>
        <translation>Peindre une barrière</translation>
    </message>
    <message>
        <source>Erase wall</source>
        <translation>Effacer une barrière</translation>
    </message>
    <message>
        <source>The surface has not come to rest yet: nothing is pinned.</source>
        <translation>La surface n’est pas encore au repos : rien n’est fixé.</translation>
    </message>
    <message>
        <source>Pin here</source>
        <translation>Fixer ici</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fixer</translation>
    </message>
    <message>
        <source>This part of the surface is pinned already.</source>
        <translation>Cette partie de la surface est déjà fixée.</translation>
    </message>
    <message>
        <source>No vertex of the surface lies within %1 mm of %2 mm: nothing is pinned.</source>
        <translation>Aucun sommet de la surface à moins de %1 mm de %2 mm : rien n’est fixé.</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Libérer</translation>
    </message>
    <message>
        <source>Keep apart</source>
        <translation>Garder séparé</translation>
    </message>
    <message>
        <source>Keep as it is</source>
        <translation>Garder tel quel</translation>
    </message>
    <message>
        <source>Wall here</source>
        <translation>Barrière ici</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Laisser faire</translation>
    </message>
    <message>
        <source>Remove component</source>
        <translation>Retirer la composante</translation>
    </message>
    <message>
        <source>Keep only one component</source>
        <translation>Ne garder qu’une composante</translation>
    </message>
    <message>
        <source>Fill cavity</source>
        <translation>Remplir la cavité</translation>
    </message>
    <message>
        <source>Smooth here</source>
        <translation>Lisser ici</translation>
    </message>
    <message>
        <source>Pull here</source>
        <translation>Tirer ici</translation>
    </message>
    <message>
        <source>Cut here</source>
        <translation>Couper ici</translation>
    </message>
    <message>
        <source>Cut handle</source>
        <translation>Couper l’anse</translation>
    </message>
    <message>
        <source>Fill tunnel</source>
        <translation>Remplir le tunnel</translation>
    </message>
    <message>
        <source>Close tunnel</source>
        <translation>Fermer le tunnel</translation>
    </message>
    <message>
        <source>Leave out an edit</source>
        <translation>Omettre une retouche</translation>
    </message>
    <message>
        <source>Object %1</source>
        <translation>Objet %1</translation>
    </message>
    <message>
        <source>Add object</source>
        <translation>Ajouter un objet</translation>
    </message>
    <message>
        <source>Duplicate object</source>
        <translation>Dupliquer l’objet</translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it first.</source>
        <translation>« %1 » est verrouillé : déverrouillez-le d’abord.</translation>
    </message>
    <message>
        <source>Delete object</source>
        <translation>Supprimer l’objet</translation>
    </message>
    <message>
        <source>Move object in the list</source>
        <translation>Déplacer l’objet dans la liste</translation>
    </message>
    <message>
        <source>Another object is called “%1”.</source>
        <translation>Un autre objet s’appelle « %1 ».</translation>
    </message>
    <message>
        <source>“%1” has the label value %2.</source>
        <translation>« %1 » a la valeur d’étiquette %2.</translation>
    </message>
    <message>
        <source>Show object</source>
        <translation>Montrer l’objet</translation>
    </message>
    <message>
        <source>Hide object</source>
        <translation>Masquer l’objet</translation>
    </message>
    <message>
        <source>Lock object</source>
        <translation>Verrouiller l’objet</translation>
    </message>
    <message>
        <source>Unlock object</source>
        <translation>Déverrouiller l’objet</translation>
    </message>
    <message>
        <source>“%1” meets “%2”, and nothing was written: grow it anew, so that it keeps clear.</source>
        <translation>« %1 » rencontre « %2 », et rien n’a été écrit : refaites-le grandir pour qu’il reste à distance.</translation>
    </message>
    <message>
        <source>There is no surface to export yet: grow one first.</source>
        <translation>Il n’y a pas encore de surface à exporter : faites-en d’abord grandir une.</translation>
    </message>
    <message>
        <source>Nothing is left of the surface at this iteration: step back to one that has some.</source>
        <translation>Il ne reste rien de la surface à cette itération : revenez à une où il en reste.</translation>
    </message>
    <message>
        <source>There is no surface to report on yet: grow one first.</source>
        <translation>Il n’y a pas encore de surface à décrire : faites-en d’abord grandir une.</translation>
    </message>
    <message>
        <source>There is nothing to save yet: open a volume first.</source>
        <translation>Il n’y a encore rien à enregistrer : ouvrez d’abord un volume.</translation>
    </message>
    <message>
        <source>A session needs a seed: place one inside the object first.</source>
        <translation>Une session a besoin d’un germe : placez-en d’abord un dans l’objet.</translation>
    </message>
    <message>
        <source>There is no seed yet: place one inside the object first.</source>
        <translation>Il n’y a pas encore de germe : placez-en d’abord un dans l’objet.</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>Retenir</translation>
    </message>
    <message>
        <source>The volume has one time point only.</source>
        <translation>Le volume n’a qu’un seul instant.</translation>
    </message>
    <message>
        <source>Frame %1 is being corrected: end that first.</source>
        <translation>L’image %1 est en cours de correction : terminez d’abord.</translation>
    </message>
    <message>
        <source>In this frame the surface is grown: change it there as ever.</source>
        <translation>La surface a crû dans cette image : modifiez-la ici comme d’habitude.</translation>
    </message>
    <message>
        <source>The surface is being carried: wait until that is done, or cancel it.</source>
        <translation>La surface est en cours de transport : attendez la fin ou annulez.</translation>
    </message>
    <message>
        <source>The surface has not been carried to this frame yet.</source>
        <translation>La surface n’a pas encore été portée jusqu’à cette image.</translation>
    </message>
    <message>
        <source>The correction has no surface at rest yet: let it grow, or pause it.</source>
        <translation>La correction n’a pas encore de surface au repos : laissez-la croître ou mettez en pause.</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Barrières</translation>
    </message>
    <message>
        <source>Wall disc</source>
        <translation>Disque barrière</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Fixations</translation>
    </message>
    <message>
        <source>Veto</source>
        <translation>Veto</translation>
    </message>
    <message>
        <source>Edit by hand</source>
        <translation>Modification à la main</translation>
    </message>
    <message>
        <source>Limits of the topology</source>
        <translation>Limites de la topologie</translation>
    </message>
    <message>
        <source>Decided: let it happen</source>
        <translation>Décidé : laisser faire</translation>
    </message>
    <message>
        <source>Decided: hold it</source>
        <translation>Décidé : retenir</translation>
    </message>
    <message>
        <source>Clicks</source>
        <translation>Points</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>A frame is being corrected: end that first.</source>
        <translation>Une image est en cours de correction : terminez d’abord.</translation>
    </message>
    <message>
        <source>Open object</source>
        <translation>Ouvrir un objet</translation>
    </message>
    <message>
        <source>Open objects</source>
        <translation>Ouvrir des objets</translation>
    </message>
    <message>
        <source>Frame %1 is shown, and the surface is grown in frame %2: go there to change it.</source>
        <translation>L’image %1 est affichée et la surface a crû dans l’image %2 : allez-y pour la modifier.</translation>
    </message>
    <message>
        <source>Grow in frame %1</source>
        <translation>Croître dans l’image %1</translation>
    </message>
    <message>
        <source>Several objects are not carried over time: open the volume with one of them.</source>
        <translation>Plusieurs objets ne sont pas portés au fil du temps : ouvrez le volume avec l’un d’eux.</translation>
    </message>
    <message>
        <source>The surface still grows: wait until it is at rest.</source>
        <translation>La surface croît encore : attendez qu’elle soit au repos.</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one in a frame first.</source>
        <translation>Il n’y a pas encore de surface : faites-en d’abord croître une dans une image.</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Au fil du temps</translation>
    </message>
    <message>
        <source>There are no surfaces over time of what is shown: carry it through the frames first.</source>
        <translation>Il n’y a pas de surfaces au fil du temps pour ce qui est affiché : portez-le d’abord à travers les images.</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>There is no surface yet: grow one first.</source>
        <translation>Il n’y a pas encore de surface : faites-en d’abord grandir une.</translation>
    </message>
    <message>
        <source>It is told of the frame that the surface is grown in: go there first.</source>
        <translation>Cela concerne l’image dans laquelle la surface a crû : allez-y d’abord.</translation>
    </message>
    <message>
        <source>It is told of a surface that has come to rest: let it grow to its end first.</source>
        <translation>Cela concerne une surface au repos : laissez-la d’abord croître jusqu’au bout.</translation>
    </message>
    <message>
        <source>polished: %1 bad places, now %2; least angle %3°, was %4°.</source>
        <translation>amélioré : %1 mauvais endroits, maintenant %2 ; plus petit angle %3°, avant %4°.</translation>
    </message>
    <message>
        <source>“%1” %2</source>
        <translation>« %1 » %2</translation>
    </message>
    <message>
        <source>A surface that comes from a file is not carried over time: grow one from a click.</source>
        <translation>Une surface qui vient d’un fichier n’est pas portée dans le temps : faites-en croître une à partir d’un clic.</translation>
    </message>
    <message>
        <source>The name is empty.</source>
        <translation>Le nom est vide.</translation>
    </message>
    <message>
        <source>The name “%1” is not UTF-8.</source>
        <translation>Le nom « %1 » n’est pas en UTF-8.</translation>
    </message>
    <message>
        <source>The name “%1” has more than %2 characters.</source>
        <translation>Le nom « %1 » a plus de %2 caractères.</translation>
    </message>
    <message>
        <source>The name “%1” holds a control character.</source>
        <translation>Le nom « %1 » contient un caractère de contrôle.</translation>
    </message>
    <message>
        <source>The name “%1” holds %2, which separates in some of the formats.</source>
        <translation>Le nom « %1 » contient %2, qui sert de séparateur dans certains formats.</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>%1 cannot be written: it would be a part of the volume that is open. Choose another folder or name.</source>
        <translation>%1 ne peut pas être écrit : il ferait partie du volume ouvert. Choisissez un autre dossier ou un autre nom.</translation>
    </message>
    <message>
        <source>A session keeps work over time of one object only: save this one, then open the volume anew to have several objects.</source>
        <translation>Une session ne garde le travail dans le temps que d’un seul objet : enregistrez celle-ci, puis rouvrez le volume pour avoir plusieurs objets.</translation>
    </message>
    <message>
        <source>“%1” still grows: wait until it is at rest, or pause it.</source>
        <translation>« %1 » croît encore : attendez qu’il soit au repos, ou mettez-le en pause.</translation>
    </message>
    <message>
        <source>%1 cannot be written: the open work is read from it. Choose another folder or name.</source>
        <translation>%1 ne peut pas être écrit : le travail ouvert en est lu. Choisissez un autre dossier ou un autre nom.</translation>
    </message>
    <message>
        <source>Work over time is left out while there are several objects: delete all but one to keep it.</source>
        <translation>Le travail dans le temps est laissé de côté tant qu’il y a plusieurs objets : supprimez-les tous sauf un pour le garder.</translation>
    </message>
    <message>
        <source>“%1” is locked: unlock it to grow in another frame.</source>
        <translation>« %1 » est verrouillé : déverrouillez-le pour croître dans une autre image.</translation>
    </message>
    <message>
        <source>Nothing is kept for the case that the program ends unexpectedly: save the session. %1</source>
        <translation>Rien n’est conservé pour le cas où le programme se terminerait de façon inattendue : enregistrez la session. %1</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Of the frames %1–%2 the surface is in these only: %3. Carry it through all of them first.</source>
        <translation>Des images %1–%2, seules celles-ci ont la surface : %3. Portez-la d’abord à travers toutes.</translation>
    </message>
    <message>
        <source>Frames %1: %2</source>
        <translation>Images %1 : %2</translation>
    </message>
    <message>
        <source>The surface is still grown in frame %1: frame %2 was not shown.</source>
        <translation>La surface croît toujours dans l’image %1 : l’image %2 n’a pas été affichée.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::EventInspector</name>
    <message>
        <source>Stage 1 of 4: the triangles that run into each other.</source>
        <translation>Phase 1 sur 4 : les triangles qui se heurtent.</translation>
    </message>
    <message>
        <source>Stage 2 of 4: the mesh without them, and the polygons that bound the openings.</source>
        <translation>Phase 2 sur 4 : le maillage sans eux, et les polygones qui bordent les ouvertures.</translation>
    </message>
    <message>
        <source>Stage 3 of 4: the handle, or the caps, that close the openings.</source>
        <translation>Phase 3 sur 4 : l’anse, ou les couvercles, qui ferment les ouvertures.</translation>
    </message>
    <message>
        <source>Stage 4 of 4: the mesh with the handle in place.</source>
        <translation>Phase 4 sur 4 : le maillage avec l’anse en place.</translation>
    </message>
    <message>
        <source>Before stage 2: the edges around them are halved, or the openings would not be bounded by simple polygons.</source>
        <translation>Avant la phase 2 : les arêtes autour d’eux sont coupées en deux, sans quoi les ouvertures ne seraient pas bordées de polygones simples.</translation>
    </message>
    <message>
        <source>Handle inserted</source>
        <translation>Anse insérée</translation>
    </message>
    <message>
        <source>Split</source>
        <translation>Division</translation>
    </message>
    <message>
        <source>Enclosed part cut off</source>
        <translation>Partie enclose coupée</translation>
    </message>
    <message>
        <source>Tunnel closed</source>
        <translation>Tunnel fermé</translation>
    </message>
    <message>
        <source>Component deleted</source>
        <translation>Composante supprimée</translation>
    </message>
    <message>
        <source>Handle cut</source>
        <translation>Anse coupée</translation>
    </message>
    <message>
        <source>Component removed</source>
        <translation>Composante retirée</translation>
    </message>
    <message>
        <source>Cavity filled</source>
        <translation>Cavité remplie</translation>
    </message>
    <message>
        <source>Fold smoothed</source>
        <translation>Pli lissé</translation>
    </message>
    <message>
        <source>Cut by a plane</source>
        <translation>Coupé par un plan</translation>
    </message>
    <message>
        <source>Smoothed by hand</source>
        <translation>Lissé à la main</translation>
    </message>
    <message>
        <source>Pulled</source>
        <translation>Tiré</translation>
    </message>
    <message>
        <source>Rolled back</source>
        <translation>Annulé</translation>
    </message>
    <message>
        <source>Held: %1</source>
        <translation>Retenu : %1</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>Non</translation>
    </message>
    <message>
        <source>Collide</source>
        <translation>Choc</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Handle</source>
        <translation>Anse</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Show the whole surface</source>
        <translation>Montrer toute la surface</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Affiner</translation>
    </message>
    <message>
        <source>Keep it</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Event: %1</source>
        <translation>Événement : %1</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>à %1</translation>
    </message>
    <message>
        <source>Genus %1, components %2</source>
        <translation>Genre %1, composantes %2</translation>
    </message>
    <message>
        <source>Edit by hand: %1 → %2</source>
        <translation>Retouche à la main : %1 → %2</translation>
    </message>
    <message>
        <source>Loop of %1</source>
        <translation>Boucle de %1</translation>
    </message>
    <message>
        <source>Fronts joined: %1</source>
        <translation>Fronts joints : %1</translation>
    </message>
    <message>
        <source>Boundary polygons of %1 vertices</source>
        <translation>Polygones de bord de %1 sommets</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Laisser faire</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Omettre</translation>
    </message>
    <message>
        <source>Keep apart here</source>
        <translation>Garder séparé ici</translation>
    </message>
    <message>
        <source>Goes back to the step before this edit, and on without it</source>
        <translation>Revient au pas d’avant cette retouche, et continue sans elle</translation>
    </message>
    <message>
        <source>Goes back to the step before; grown on from there, this does not happen</source>
        <translation>Revient au pas d’avant ; en reprenant de là, cela n’arrive pas</translation>
    </message>
    <message>
        <source>From the shown step on, what is held here may happen</source>
        <translation>À partir du pas montré, ce qui est retenu ici peut arriver</translation>
    </message>
    <message>
        <source>The step is worked out again…</source>
        <translation>Le pas est recalculé…</translation>
    </message>
    <message>
        <source>The mesh was not opened here: there are no stages to show.</source>
        <translation>Le maillage n’a pas été ouvert ici : il n’y a pas de phases à montrer.</translation>
    </message>
    <message>
        <source>Nothing was refined here: the polygons were simple.</source>
        <translation>Rien n’a été affiné ici : les polygones étaient simples.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::EventTable</name>
    <message>
        <source>Step</source>
        <translation>Pas</translation>
    </message>
    <message>
        <source>Event</source>
        <translation>Événement</translation>
    </message>
    <message>
        <source>Place (LPS)</source>
        <translation>Lieu (LPS)</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Genre</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parties</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ExportPanel</name>
    <message>
        <source>Surface or label map</source>
        <translation>Surface ou carte d’étiquettes</translation>
    </message>
    <message>
        <source>Nothing has grown yet. Place a seed and start the growth first.</source>
        <translation>Rien n’a encore grandi. Placez d’abord un germe et démarrez la croissance.</translation>
    </message>
    <message>
        <source>All objects in one file</source>
        <translation>Tous les objets dans un fichier</translation>
    </message>
    <message>
        <source>The active object</source>
        <translation>L’objet actif</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>A surface keeps all detail; a label map has the voxels of the volume</source>
        <translation>Une surface garde tout le détail ; une carte d’étiquettes a les voxels du volume</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Coordonnées</translation>
    </message>
    <message>
        <source>LPS</source>
        <translation>LPS</translation>
    </message>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>x to the patient's left, y to the back, as in DICOM and ITK</source>
        <translation>x vers la gauche du patient, y vers l’arrière, comme en DICOM et ITK</translation>
    </message>
    <message>
        <source>x to the patient's right, y to the front, as in NIfTI and 3D Slicer</source>
        <translation>x vers la droite du patient, y vers l’avant, comme en NIfTI et 3D Slicer</translation>
    </message>
    <message>
        <source>Why nothing is written</source>
        <translation>Pourquoi rien n’est écrit</translation>
    </message>
    <message>
        <source>What is written</source>
        <translation>Ce qui est écrit</translation>
    </message>
    <message>
        <source>STL surface, binary</source>
        <translation>Surface STL, binaire</translation>
    </message>
    <message>
        <source>VTP surface (VTK)</source>
        <translation>Surface VTP (VTK)</translation>
    </message>
    <message>
        <source>PLY surface, binary</source>
        <translation>Surface PLY, binaire</translation>
    </message>
    <message>
        <source>OBJ surface</source>
        <translation>Surface OBJ</translation>
    </message>
    <message>
        <source>3MF surface, to print</source>
        <translation>Surface 3MF, pour imprimer</translation>
    </message>
    <message>
        <source>NIfTI label map</source>
        <translation>Carte d’étiquettes NIfTI</translation>
    </message>
    <message>
        <source>NRRD label map</source>
        <translation>Carte d’étiquettes NRRD</translation>
    </message>
    <message>
        <source>MetaImage label map</source>
        <translation>Carte d’étiquettes MetaImage</translation>
    </message>
    <message>
        <source>3D Slicer segmentation</source>
        <translation>Segmentation 3D Slicer</translation>
    </message>
    <message>
        <source>DICOM segmentation</source>
        <translation>Segmentation DICOM</translation>
    </message>
    <message>
        <source>DICOM with STL surface</source>
        <translation>DICOM avec surface STL</translation>
    </message>
    <message>
        <source>Gmsh tetrahedra</source>
        <translation>Tétraèdres Gmsh</translation>
    </message>
    <message>
        <source>VTK tetrahedra</source>
        <translation>Tétraèdres VTK</translation>
    </message>
    <message>
        <source>Abaqus tetrahedra</source>
        <translation>Tétraèdres Abaqus</translation>
    </message>
    <message>
        <source>Without what names the patient</source>
        <translation>Sans ce qui nomme le patient</translation>
    </message>
    <message>
        <source>What is being written</source>
        <translation>Ce qui est en cours d’écriture</translation>
    </message>
    <message>
        <source>A file is being written</source>
        <translation>Un fichier est en cours d’écriture</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancel writing</source>
        <translation>Annuler l’écriture</translation>
    </message>
    <message>
        <source>Writing %1…</source>
        <translation>Écriture de %1…</translation>
    </message>
    <message>
        <source>It was cancelled: nothing was written.</source>
        <translation>Annulé : rien n’a été écrit.</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>All four views</source>
        <translation>Les quatre vues</translation>
    </message>
    <message>
        <source>%1 view</source>
        <translation>Vue %1</translation>
    </message>
    <message>
        <source>Picture of</source>
        <translation>Image de</translation>
    </message>
    <message>
        <source>Which view is written as PNG</source>
        <translation>Quelle vue est écrite en PNG</translation>
    </message>
    <message>
        <source>Report and session</source>
        <translation>Rapport et session</translation>
    </message>
    <message>
        <source>The report holds every parameter, number and event. A session opens here again, and “handlebody-cli replay” makes the same mesh of it.</source>
        <translation>Le rapport contient tous les paramètres, nombres et événements. Une session se rouvre ici, et « handlebody-cli replay » en refait le même maillage.</translation>
    </message>
    <message>
        <source>Objects: %1; %2 together.</source>
        <translation>Objets : %1 ; %2 ensemble.</translation>
    </message>
    <message>
        <source>Without a surface: %1.</source>
        <translation>Sans surface : %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Made with earlier surfaces: %1. Nothing is written if any of them meet.</source>
        <translation>Faits avec des surfaces antérieures : %1. Rien n’est écrit si certains se rencontrent.</translation>
    </message>
    <message>
        <source>Nothing is left of the surface at this iteration.</source>
        <translation>Il ne reste rien de la surface à cette itération.</translation>
    </message>
    <message>
        <source>Iteration %1: %2, %3</source>
        <translation>Itération %1 : %2, %3</translation>
    </message>
    <message>
        <source>What was bettered</source>
        <translation>Ce qui a été amélioré</translation>
    </message>
    <message>
        <source>glTF scene, to view</source>
        <translation>Scène glTF, à regarder</translation>
    </message>
    <message>
        <source>Better thin triangles</source>
        <translation>Améliorer les triangles fins</translation>
    </message>
    <message>
        <source>Triangles with an angle under 15° and edges sharper than 20°, which a solver cannot use, are made better in what is written; the surface goes no farther than a tenth of a voxel. The session keeps this choice.</source>
        <translation>Les triangles avec un angle de moins de 15° et les arêtes plus vives que 20°, inutilisables pour un solveur, sont améliorés dans ce qui est écrit ; la surface ne bouge pas de plus d’un dixième de voxel. La session conserve ce choix.</translation>
    </message>
    <message>
        <source>Bettering the triangles of “%1”…</source>
        <translation>Amélioration des triangles de « %1 »…</translation>
    </message>
    <message>
        <source>Bettering the triangles…</source>
        <translation>Amélioration des triangles…</translation>
    </message>
    <message>
        <source>Creator</source>
        <translation>Créateur</translation>
    </message>
    <message>
        <source>Who made it, as DICOM writes names: Family^Given. May stay empty</source>
        <translation>Qui l’a fait, comme DICOM écrit les noms : Nom^Prénom. Peut rester vide</translation>
    </message>
    <message>
        <source>Description</source>
        <translation>Description</translation>
    </message>
    <message>
        <source>What it is for. May stay empty</source>
        <translation>À quoi cela sert. Peut rester vide</translation>
    </message>
    <message>
        <source>ITK-SNAP label description</source>
        <translation>Description des étiquettes pour ITK-SNAP</translation>
    </message>
    <message>
        <source>DICOM files, report and measures are written without patient, study, dates and names of files, and the names that are suggested do not tell the volume's. In place of saving the session one is exported that does not say where its volume is: it asks for it when it is opened.</source>
        <translation>Les fichiers DICOM, le rapport et les mesures sont écrits sans patient, étude, dates ni noms de fichiers, et les noms proposés ne révèlent pas celui du volume. Au lieu d’enregistrer la session, on en exporte une qui ne dit pas où se trouve son volume : elle le demande à l’ouverture.</translation>
    </message>
    <message>
        <source>Each object in a file of its own</source>
        <translation>Chaque objet dans son propre fichier</translation>
    </message>
    <message>
        <source>What a file holds: names and colours stay apart where it can; to the name of a file of one object its name is added</source>
        <translation>Ce que contient un fichier : noms et couleurs restent séparés là où il le permet ; le nom de l'objet est ajouté à celui du fichier d'un seul objet</translation>
    </message>
    <message>
        <source>Nothing is left of the file, nor of those that wait</source>
        <translation>Il ne reste rien du fichier, ni de ceux qui attendent</translation>
    </message>
    <message>
        <source>Waiting: %1.</source>
        <translation>En attente : %1.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::FileWork</name>
    <message>
        <source>%1 is written.</source>
        <translation>%1 est écrit.</translation>
    </message>
    <message>
        <source>The session is saved as %1.</source>
        <translation>La session est enregistrée sous %1.</translation>
    </message>
    <message>
        <source>A replay grows anew: %1.</source>
        <translation>Une relecture refait grandir : %1.</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Open a volume or a session</source>
        <translation>Ouvrir un volume ou une session</translation>
    </message>
    <message>
        <source>Open a folder with a DICOM series</source>
        <translation>Ouvrir un dossier contenant une série DICOM</translation>
    </message>
    <message>
        <source>Enter the spacing</source>
        <translation>Saisir l’espacement</translation>
    </message>
    <message>
        <source>The sample is not installed with this program.</source>
        <translation>L’exemple n’est pas installé avec ce programme.</translation>
    </message>
    <message>
        <source>Unsaved work</source>
        <translation>Travail non enregistré</translation>
    </message>
    <message>
        <source>Save the seeds and parameters first?</source>
        <translation>Enregistrer d’abord les germes et les paramètres ?</translation>
    </message>
    <message>
        <source>They are kept in a session, from which the same surface can be grown again.</source>
        <translation>Ils sont gardés dans une session, d’où la même surface peut grandir à nouveau.</translation>
    </message>
    <message>
        <source>Save the session</source>
        <translation>Enregistrer la session</translation>
    </message>
    <message>
        <source>Sessions (*.json)</source>
        <translation>Sessions (*.json)</translation>
    </message>
    <message>
        <source>Export the result</source>
        <translation>Exporter le résultat</translation>
    </message>
    <message>
        <source>Export the report</source>
        <translation>Exporter le rapport</translation>
    </message>
    <message>
        <source>Export a picture</source>
        <translation>Exporter une image</translation>
    </message>
    <message>
        <source>%1 cannot be written: %2.</source>
        <translation>%1 ne peut pas être écrit : %2.</translation>
    </message>
    <message>
        <source>The program ended unexpectedly last time. Its seeds and parameters were kept.</source>
        <translation>Le programme s’est terminé de façon inattendue la dernière fois. Ses germes et paramètres ont été gardés.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Restaurer</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Abandonner</translation>
    </message>
    <message>
        <source>Volumes and sessions (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.tif *.tiff *.dcm *.json);;All files (*)</source>
        <translation>Volumes et sessions (*.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.tif *.tiff *.dcm *.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Open a mesh or a label map</source>
        <translation>Ouvrir un maillage ou une carte d’étiquettes</translation>
    </message>
    <message>
        <source>Open objects</source>
        <translation>Ouvrir des objets</translation>
    </message>
    <message>
        <source>Making surfaces of %1…</source>
        <translation>Création des surfaces de %1…</translation>
    </message>
    <message>
        <source>%1 is open as: %2.</source>
        <translation>%1 est ouvert comme : %2.</translation>
    </message>
    <message>
        <source>%1 is a surface: open the volume first that it lies in.</source>
        <translation>%1 est une surface : ouvrez d’abord le volume dans lequel elle se trouve.</translation>
    </message>
    <message>
        <source>Export a 4D label map</source>
        <translation>Exporter une carte d’étiquettes 4D</translation>
    </message>
    <message>
        <source>Export the meshes of all frames</source>
        <translation>Exporter les maillages de toutes les images</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>Choisir le fichier…</translation>
    </message>
    <message>
        <source>Choose the folder…</source>
        <translation>Choisir le dossier…</translation>
    </message>
    <message>
        <source>Choose what the session needs</source>
        <translation>Choisir ce dont la session a besoin</translation>
    </message>
    <message>
        <source>Export an anonymous session</source>
        <translation>Exporter une session anonyme</translation>
    </message>
    <message>
        <source>Segments overlap: what several of them hold is left to the smallest (voxels: %1). Step 4, Grow, tells it of each.</source>
        <translation>Des segments se chevauchent : ce que plusieurs d’entre eux contiennent est laissé au plus petit (voxels : %1). L’étape 4, Croissance, le dit de chacun.</translation>
    </message>
    <message>
        <source>Meshes and label maps (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;All files (*)</source>
        <translation>Maillages et cartes d’étiquettes (*.stl *.vtp *.ply *.obj *.3mf *.nii *.nii.gz *.nrrd *.nhdr *.mha *.mhd *.gipl *.gipl.gz *.dcm);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>There already: %1. Replace what is there?</source>
        <translation>Déjà présents : %1. Remplacer ce qui s'y trouve ?</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 de plus</translation>
    </message>
    <message>
        <source>A file is being written. The window closes when it is done.</source>
        <translation>Un fichier est en cours d’écriture. La fenêtre se fermera quand il sera terminé.</translation>
    </message>
    <message>
        <source>Stay open</source>
        <translation>Rester ouverte</translation>
    </message>
    <message>
        <source>%1 was changed elsewhere since it was opened or saved here. Replace what is there?</source>
        <translation>%1 a été modifié ailleurs depuis son ouverture ou son enregistrement ici. Remplacer ce qui s’y trouve ?</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>Écraser</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::FrameSlider</name>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>&lt;p&gt;Time: the frames of the volume. A ring is the frame the surface is grown in, dots are frames it was carried to: orange with a warning, red where it failed. Click or drag to go there.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Temps : les images du volume. Un anneau est l’image dans laquelle la surface a crû, les points sont les images où elle a été portée : orange avec un avertissement, rouge en cas d’échec. Cliquez ou glissez pour y aller.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::GrowPanel</name>
    <message>
        <source>not closed</source>
        <translation>non fermée</translation>
    </message>
    <message>
        <source>not manifold</source>
        <translation>non variété</translation>
    </message>
    <message>
        <source>not oriented</source>
        <translation>non orientée</translation>
    </message>
    <message>
        <source>self-intersections: %1</source>
        <translation>auto-intersections : %1</translation>
    </message>
    <message>
        <source>parts that lie wrongly in each other: %1</source>
        <translation>parties mal imbriquées : %1</translation>
    </message>
    <message>
        <source>self-intersections not checked</source>
        <translation>auto-intersections non vérifiées</translation>
    </message>
    <message>
        <source>Finished: the surface is at rest</source>
        <translation>Terminé : la surface est au repos</translation>
    </message>
    <message>
        <source>Stopped at the iteration limit</source>
        <translation>Arrêté à la limite d’itérations</translation>
    </message>
    <message>
        <source>Finished: nothing is left of the surface</source>
        <translation>Terminé : il ne reste rien de la surface</translation>
    </message>
    <message>
        <source>At rest, but parts that could not be mended would still move</source>
        <translation>Au repos, mais des parties irréparables bougeraient encore</translation>
    </message>
    <message>
        <source>Stuck: no part of a step could be kept</source>
        <translation>Bloqué : aucune partie d’un pas n’a pu être conservée</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>⚠ Worth a look</source>
        <translation>⚠ À vérifier</translation>
    </message>
    <message>
        <source>iteration %1 of %2</source>
        <translation>itération %1 sur %2</translation>
    </message>
    <message>
        <source>Preparing the image…</source>
        <translation>Préparation de l’image…</translation>
    </message>
    <message>
        <source>Growing</source>
        <translation>Croissance</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>En pause</translation>
    </message>
    <message>
        <source>No seed yet</source>
        <translation>Pas encore de germe</translation>
    </message>
    <message>
        <source>Ready to grow</source>
        <translation>Prêt à grandir</translation>
    </message>
    <message>
        <source>Nothing grew</source>
        <translation>Rien n’a grandi</translation>
    </message>
    <message>
        <source>These clicks mean another object: begun anew at iteration %1</source>
        <translation>Ces points visent un autre objet : recommencé à l’itération %1</translation>
    </message>
    <message>
        <source>Clicks changed at iteration %1: gone on from there</source>
        <translation>Points changés à l’itération %1 : repris de là</translation>
    </message>
    <message>
        <source>Start grows the surface from the seeds. You may pause, go back exactly, change a click or a parameter and go on from there at any time.</source>
        <translation>Démarrer fait grandir la surface à partir des germes. Vous pouvez à tout moment mettre en pause, revenir exactement en arrière, changer un point ou un paramètre et continuer de là.</translation>
    </message>
    <message>
        <source>State of the growth</source>
        <translation>État de la croissance</translation>
    </message>
    <message>
        <source>Why it did not grow</source>
        <translation>Pourquoi rien n’a grandi</translation>
    </message>
    <message>
        <source>Doubts about the surface</source>
        <translation>Doutes sur la surface</translation>
    </message>
    <message>
        <source>Steps per frame</source>
        <translation>Pas par image</translation>
    </message>
    <message>
        <source>How many iterations the surface goes on between two pictures of it</source>
        <translation>De combien d’itérations la surface avance entre deux images</translation>
    </message>
    <message>
        <source>Pause at a leak</source>
        <translation>Pause en cas de fuite</translation>
    </message>
    <message>
        <source>The growth pauses where the surface has come through a passage much narrower than what lies on both sides of it</source>
        <translation>La croissance s’arrête là où la surface a franchi un passage bien plus étroit que ce qui se trouve des deux côtés</translation>
    </message>
    <message>
        <source>Surface now</source>
        <translation>Surface actuelle</translation>
    </message>
    <message>
        <source>Certificate</source>
        <translation>Certificat</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Volume enclosed by the surface</source>
        <translation>Volume enfermé par la surface</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Area of the surface</source>
        <translation>Aire de la surface</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Composantes</translation>
    </message>
    <message>
        <source>Connected parts of the surface</source>
        <translation>Parties connexes de la surface</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Genre</translation>
    </message>
    <message>
        <source>Holes as in a ring: in all, and of each component</source>
        <translation>Trous comme dans un anneau : en tout, et par composante</translation>
    </message>
    <message>
        <source>Euler number</source>
        <translation>Nombre d’Euler</translation>
    </message>
    <message>
        <source>Vertices minus edges plus faces</source>
        <translation>Sommets moins arêtes plus faces</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>Vertices of the mesh</source>
        <translation>Sommets du maillage</translation>
    </message>
    <message>
        <source>Nothing is left of the surface</source>
        <translation>Il ne reste rien de la surface</translation>
    </message>
    <message>
        <source>✓ Closed, manifold, free of self-intersections</source>
        <translation>✓ Fermée, variété, sans auto-intersections</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>As it was opened: nothing grows</source>
        <translation>Telle qu’ouverte : rien ne croît</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HeldSection</name>
    <message>
        <source>What is held back</source>
        <translation>Ce qui est retenu</translation>
    </message>
    <message>
        <source>Nothing is held back.</source>
        <translation>Rien n’est retenu.</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Where (mm LPS)</source>
        <translation>Où (mm LPS)</translation>
    </message>
    <message>
        <source>What is held back, each with its place</source>
        <translation>Ce qui est retenu, chacun avec son lieu</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>Lever</translation>
    </message>
    <message>
        <source>At most %1 components</source>
        <translation>Composantes : %1 au plus</translation>
    </message>
    <message>
        <source>Lift the limit</source>
        <translation>Lever la limite</translation>
    </message>
    <message>
        <source>Genus at most %1</source>
        <translation>Genre : %1 au plus</translation>
    </message>
    <message>
        <source>May break the limits</source>
        <translation>Peut dépasser les limites</translation>
    </message>
    <message>
        <source>Allow no more</source>
        <translation>Ne plus permettre</translation>
    </message>
    <message>
        <source>Veto at iteration %1</source>
        <translation>Veto à l’itération %1</translation>
    </message>
    <message>
        <source>Lift the veto</source>
        <translation>Lever le veto</translation>
    </message>
    <message>
        <source>Pin at iteration %1</source>
        <translation>Fixation à l’itération %1</translation>
    </message>
    <message>
        <source>%1, %2 balls</source>
        <translation>%1, %2 boules</translation>
    </message>
    <message>
        <source>Lift the pin</source>
        <translation>Lever la fixation</translation>
    </message>
    <message>
        <source>Disc, radius %1</source>
        <translation>Disque, rayon %1</translation>
    </message>
    <message>
        <source>Lift the disc</source>
        <translation>Lever le disque</translation>
    </message>
    <message>
        <source>Walls of %1</source>
        <translation>Barrières de %1</translation>
    </message>
    <message>
        <source>Lift the map of walls</source>
        <translation>Lever la carte des barrières</translation>
    </message>
    <message>
        <source>Held: %1</source>
        <translation>Retenu : %1</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Laisser faire</translation>
    </message>
    <message>
        <source>From the shown iteration on the chosen one holds nothing back</source>
        <translation>À partir de l’itération montrée, l’élément choisi ne retient plus rien</translation>
    </message>
    <message>
        <source>Held, as you decided</source>
        <translation>Retenu, comme vous l’avez décidé</translation>
    </message>
    <message>
        <source>Decide again</source>
        <translation>Décider à nouveau</translation>
    </message>
    <message>
        <source>To decide: %1</source>
        <translation>À décider : %1</translation>
    </message>
    <message>
        <source>%1 around</source>
        <translation>%1 de tour</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HelpWindow</name>
    <message>
        <source>Handlebody: help</source>
        <translation>Handlebody : aide</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>Keyboard and mouse</source>
        <translation>Clavier et souris</translation>
    </message>
    <message>
        <source>About</source>
        <translation>À propos</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::HistogramView</name>
    <message>
        <source>Histogram with the object's range</source>
        <translation>Histogramme avec l’intervalle de l’objet</translation>
    </message>
    <message>
        <source>&lt;p&gt;How often each intensity occurs (square root). Drag the ends of the object's range; with the keyboard: Up and Down choose an end, Left and Right move it.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Fréquence de chaque intensité (racine carrée). Glissez les bornes de l’intervalle de l’objet ; au clavier : Haut et Bas choisissent une borne, Gauche et Droite la déplacent.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>De %1 à %2</translation>
    </message>
    <message>
        <source>No range yet</source>
        <translation>Pas encore d’intervalle</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::LabelChoice</name>
    <message>
        <source>Label %1</source>
        <translation>Étiquette %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>&amp;Labels to open</source>
        <translation>Étiquettes à &amp;ouvrir</translation>
    </message>
    <message>
        <source>Labels to open</source>
        <translation>Étiquettes à ouvrir</translation>
    </message>
    <message>
        <source>Each that is checked becomes an object, called and coloured as the file says</source>
        <translation>Chacune qui est cochée devient un objet, avec le nom et la couleur que donne le fichier</translation>
    </message>
    <message>
        <source>&amp;All</source>
        <translation>To&amp;utes</translation>
    </message>
    <message>
        <source>Checks all labels</source>
        <translation>Coche toutes les étiquettes</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Aucune</translation>
    </message>
    <message>
        <source>Checks no label</source>
        <translation>Ne coche aucune étiquette</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::LocalSection</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Radius at the crosshair</source>
        <translation>Rayon au réticule</translation>
    </message>
    <message>
        <source>Of the ball in which the surface is pinned or smoothed, and how far along it a pull reaches</source>
        <translation>De la boule où la surface est fixée ou lissée, et jusqu’où une traction s’étend</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fixer</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Tirer</translation>
    </message>
    <message>
        <source>Plane</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Axial</source>
        <translation>Axiale</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronale</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittale</translation>
    </message>
    <message>
        <source>Cut as the axial slices lie</source>
        <translation>Couper comme les coupes axiales</translation>
    </message>
    <message>
        <source>Cut as the coronal slices lie</source>
        <translation>Couper comme les coupes coronales</translation>
    </message>
    <message>
        <source>Cut as the sagittal slices lie</source>
        <translation>Couper comme les coupes sagittales</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>Superior</source>
        <translation>Supérieur</translation>
    </message>
    <message>
        <source>Inferior</source>
        <translation>Inférieur</translation>
    </message>
    <message>
        <source>Both sides of the cut stay</source>
        <translation>Les deux côtés de la coupe restent</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Posterior</source>
        <translation>Postérieur</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Gauche</translation>
    </message>
    <message>
        <source>Anterior</source>
        <translation>Antérieur</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Droite</translation>
    </message>
    <message>
        <source>Keep: %1</source>
        <translation>Garder : %1</translation>
    </message>
    <message>
        <source>Only what lies on this side of the plane stays</source>
        <translation>Seul reste ce qui est de ce côté du plan</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MainWindow</name>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Chronologie</translation>
    </message>
    <message>
        <source>Walls</source>
        <translation>Barrières</translation>
    </message>
    <message>
        <source>Paint in the slices where the surface may not go, from the shown iteration on. Ctrl+wheel changes the radius.</source>
        <translation>Peignez dans les coupes là où la surface ne doit pas aller, à partir de l’itération montrée. Ctrl+molette change le rayon.</translation>
    </message>
    <message>
        <source>On the surface</source>
        <translation>Sur la surface</translation>
    </message>
    <message>
        <source>With the brush, in the slices and in 3D: drag to pin or unpin, click to smooth, drag a point to pull it. The radius is the same. A line drawn across it in a slice cuts it.</source>
        <translation>Au pinceau, dans les coupes et en 3D : glisser pour fixer ou libérer, cliquer pour lisser, tirer un point pour déformer. Le rayon est le même. Une ligne en travers dans une coupe la coupe.</translation>
    </message>
    <message>
        <source>Held back</source>
        <translation>Retenu</translation>
    </message>
    <message>
        <source>Limits, vetoes, pins and discs. The crosshair goes to the chosen one; lifted, it holds no more from the shown iteration on.</source>
        <translation>Limites, vetos, fixations et disques. Le réticule va à l’élément choisi ; levé, il ne retient plus rien à partir de l’itération montrée.</translation>
    </message>
    <message>
        <source>At the crosshair</source>
        <translation>Au réticule</translation>
    </message>
    <message>
        <source>A pin holds the surface in a ball. To smooth, pull and cut is the next step.</source>
        <translation>Une fixation retient la surface dans une boule. Lisser, tirer et couper forment le pas suivant.</translation>
    </message>
    <message>
        <source>The surface is pinned here from iteration %1 on.</source>
        <translation>La surface est fixée ici à partir de l’itération %1.</translation>
    </message>
    <message>
        <source>Tunnels and pieces</source>
        <translation>Tunnels et morceaux</translation>
    </message>
    <message>
        <source>What the shown surface holds, and what can be done to it: each edit is the next step.</source>
        <translation>Ce que contient la surface montrée et ce qu’on peut en faire : chaque retouche est le pas suivant.</translation>
    </message>
    <message>
        <source>Several files were dropped; the first one is opened. For a DICOM series drop its folder.</source>
        <translation>Plusieurs fichiers ont été déposés ; le premier est ouvert. Pour une série DICOM, déposez son dossier.</translation>
    </message>
    <message>
        <source>The language changes when the program is started again.</source>
        <translation>La langue change au prochain démarrage du programme.</translation>
    </message>
    <message>
        <source>P&amp;ause</source>
        <translation>Paus&amp;e</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Continuer</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Démarrer</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1: %2, was %3.</source>
        <translation>%1 : %2, était %3.</translation>
    </message>
    <message>
        <source>A leak at iteration %1: %2.</source>
        <translation>Une fuite à l’itération %1 : %2.</translation>
    </message>
    <message>
        <source>Wall here</source>
        <translation>Barrière ici</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Revenir</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>“%1” came through a narrow passage.</source>
        <translation>« %1 » a franchi un passage étroit.</translation>
    </message>
    <message>
        <source>Show it</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Handlebody</source>
        <translation>Handlebody</translation>
    </message>
    <message>
        <source>%1[*] – Handlebody</source>
        <translation>%1[*] – Handlebody</translation>
    </message>
    <message>
        <source>Handlebody[*]</source>
        <translation>Handlebody[*]</translation>
    </message>
    <message>
        <source>Remove all walls</source>
        <translation>Supprimer toutes les barrières</translation>
    </message>
    <message>
        <source>Remove all pins</source>
        <translation>Supprimer toutes les fixations</translation>
    </message>
    <message>
        <source>The surface is already where the wall is.</source>
        <translation>La surface est déjà là où est la barrière.</translation>
    </message>
    <message>
        <source>Go back to before it came in here</source>
        <translation>Revenir avant qu’elle n’y entre</translation>
    </message>
    <message>
        <source>Push it out</source>
        <translation>La repousser</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Laisser faire</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>Retenir</translation>
    </message>
    <message>
        <source>“%1” has paused: a change of its topology is held, for you to decide.</source>
        <translation>« %1 » est en pause : un changement de topologie est retenu, à vous de décider.</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Au fil du temps</translation>
    </message>
    <message>
        <source>&amp;Stop playing</source>
        <translation>&amp;Arrêter</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lire</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>Annul&amp;er</translation>
    </message>
    <message>
        <source>&amp;Over time</source>
        <translation>Au fil du t&amp;emps</translation>
    </message>
    <message>
        <source>These objects lose their surfaces, too, and undo does not bring them back: %1. Grow in this frame?</source>
        <translation>Ces objets perdent aussi leurs surfaces, et Annuler ne les rétablit pas : %1. Croître dans cette image ?</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Grow in this frame</source>
        <translation>Croître dans cette image</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::Measurements</name>
    <message>
        <source>Ruler %1</source>
        <translation>Règle %1</translation>
    </message>
    <message>
        <source>Angle %1</source>
        <translation>Angle %1</translation>
    </message>
    <message>
        <source>Add ruler</source>
        <translation>Ajouter une règle</translation>
    </message>
    <message>
        <source>Add angle</source>
        <translation>Ajouter un angle</translation>
    </message>
    <message>
        <source>Move ruler</source>
        <translation>Déplacer la règle</translation>
    </message>
    <message>
        <source>Move angle</source>
        <translation>Déplacer l’angle</translation>
    </message>
    <message>
        <source>Delete ruler</source>
        <translation>Supprimer la règle</translation>
    </message>
    <message>
        <source>Delete angle</source>
        <translation>Supprimer l’angle</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MeasuresPanel</name>
    <message>
        <source>What is measured</source>
        <translation>Ce qui est mesuré</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>Rulers and angles</source>
        <translation>Règles et angles</translation>
    </message>
    <message>
        <source>Centre line</source>
        <translation>Ligne centrale</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>Comparer</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Sensibilité</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::MessageBar</name>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Information</translation>
    </message>
    <message>
        <source>Message</source>
        <translation>Message</translation>
    </message>
    <message>
        <source>Close the message</source>
        <translation>Fermer le message</translation>
    </message>
    <message>
        <source>Close the message (Esc)</source>
        <translation>Fermer le message (Échap)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectChoice</name>
    <message>
        <source>The only one: %1</source>
        <translation>Le seul : %1</translation>
    </message>
    <message>
        <source>%1 of %2 by size: %3</source>
        <translation>%1 sur %2 par taille : %3</translation>
    </message>
    <message>
        <source>%1 (likeliest)</source>
        <translation>%1 (le plus probable)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Which object is taken</source>
        <translation>Quel objet est pris</translation>
    </message>
    <message>
        <source>Whether the choice is sure</source>
        <translation>Si le choix est sûr</translation>
    </message>
    <message>
        <source>A close choice: look at the others, too.</source>
        <translation>Un choix serré : regardez aussi les autres.</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>Plus petit</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>Plus grand</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectDialog</name>
    <message>
        <source>Properties of the object</source>
        <translation>Propriétés de l’objet</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>What the object is called in the list and in files that hold names</source>
        <translation>Comment l’objet s’appelle dans la liste et dans les fichiers qui contiennent des noms</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Of its surface and outlines, and in files that hold colours</source>
        <translation>De sa surface et de ses contours, et dans les fichiers qui contiennent des couleurs</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Couleur</translation>
    </message>
    <message>
        <source>Term</source>
        <translation>Terme</translation>
    </message>
    <message>
        <source>What it is, as a code of SNOMED CT; gives the colour, too</source>
        <translation>Ce que c’est, en code SNOMED CT ; donne aussi la couleur</translation>
    </message>
    <message>
        <source>&amp;Term</source>
        <translation>&amp;Terme</translation>
    </message>
    <message>
        <source>Label value</source>
        <translation>Valeur d’étiquette</translation>
    </message>
    <message>
        <source>Of its voxels in a label map</source>
        <translation>De ses voxels dans une carte d’étiquettes</translation>
    </message>
    <message>
        <source>&amp;Label value</source>
        <translation>&amp;Valeur d’étiquette</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Ce qui ne va pas</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Colour of the object</source>
        <translation>Couleur de l’objet</translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>Modifier l’objet</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectMeasuresPage</name>
    <message>
        <source>Measures of the objects</source>
        <translation>Mesures des objets</translation>
    </message>
    <message>
        <source>More about the chosen object</source>
        <translation>Plus sur l’objet choisi</translation>
    </message>
    <message>
        <source>State of the measures</source>
        <translation>État des mesures</translation>
    </message>
    <message>
        <source>Wall thickness</source>
        <translation>Épaisseur de paroi</translation>
    </message>
    <message>
        <source>The distance of two surfaces over their area: of two objects, or of an object and its own cavities</source>
        <translation>La distance de deux surfaces sur leur aire : de deux objets, ou d’un objet et de ses cavités</translation>
    </message>
    <message>
        <source>How much is measured</source>
        <translation>Ce qui est déjà mesuré</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Measure the surfaces as they are shown</source>
        <translation>Mesurer les surfaces telles qu’elles sont montrées</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy the table, to paste it into a spreadsheet</source>
        <translation>Copier le tableau, pour le coller dans un tableur</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Enregistrer en CSV…</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli measure --csv” writes</source>
        <translation>Le même tableau que celui qu’écrit « handlebody-cli measure --csv »</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Enregistrer en JSON…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes</source>
        <translation>La même chose que ce qu’écrit « handlebody-cli measure --json »</translation>
    </message>
    <message>
        <source>Save the measures</source>
        <translation>Enregistrer les mesures</translation>
    </message>
    <message>
        <source>No wall thickness</source>
        <translation>Sans épaisseur de paroi</translation>
    </message>
    <message>
        <source>Wall of “%1” around its cavities</source>
        <translation>Paroi de « %1 » autour de ses cavités</translation>
    </message>
    <message>
        <source>Wall from “%1” to “%2”</source>
        <translation>Paroi de « %1 » à « %2 »</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>There is no surface to measure yet: grow one first.</source>
        <translation>Il n’y a pas encore de surface à mesurer : faites-en d’abord grandir une.</translation>
    </message>
    <message>
        <source>Measuring. What is shown is of earlier surfaces.</source>
        <translation>Mesure en cours. Ce qui est montré vient de surfaces antérieures.</translation>
    </message>
    <message>
        <source>Measuring.</source>
        <translation>Mesure en cours.</translation>
    </message>
    <message>
        <source>These are measures of earlier surfaces.</source>
        <translation>Ces mesures sont celles de surfaces antérieures.</translation>
    </message>
    <message>
        <source>Nothing is measured yet.</source>
        <translation>Rien n’est encore mesuré.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ObjectsPanel</name>
    <message>
        <source>preparing</source>
        <translation>préparation</translation>
    </message>
    <message>
        <source>not grown</source>
        <translation>pas grandi</translation>
    </message>
    <message>
        <source>no seed</source>
        <translation>pas de germe</translation>
    </message>
    <message>
        <source>Objects</source>
        <translation>Objets</translation>
    </message>
    <message>
        <source>What the active object is made with</source>
        <translation>Avec quoi l’objet actif est fait</translation>
    </message>
    <message>
        <source>%1, label value %2</source>
        <translation>%1, valeur d’étiquette %2</translation>
    </message>
    <message>
        <source>Made with an earlier “%1”</source>
        <translation>Fait avec un « %1 » antérieur</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>Masquer %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Montrer %1</translation>
    </message>
    <message>
        <source>Its surface is drawn: hide it</source>
        <translation>Sa surface est dessinée : la masquer</translation>
    </message>
    <message>
        <source>Its surface is hidden: show it</source>
        <translation>Sa surface est masquée : la montrer</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>Déverrouiller %1</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>Verrouiller %1</translation>
    </message>
    <message>
        <source>Nothing of it is changed: unlock it</source>
        <translation>Rien n’en est modifié : le déverrouiller</translation>
    </message>
    <message>
        <source>Let nothing of it be changed</source>
        <translation>Ne rien en laisser modifier</translation>
    </message>
    <message>
        <source>Waits for “%1”, which comes before it and grows.</source>
        <translation>Attend « %1 », qui vient avant lui et grandit.</translation>
    </message>
    <message>
        <source>Made with an earlier “%1”. Start grows it anew.</source>
        <translation>Fait avec un « %1 » antérieur. Démarrer le refait grandir.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OpenObjectsDialog</name>
    <message>
        <source>Open objects</source>
        <translation>Ouvrir des objets</translation>
    </message>
    <message>
        <source>What are the surfaces of “%1”?</source>
        <translation>Que sont les surfaces de « %1 » ?</translation>
    </message>
    <message>
        <source>Objects that are done stay as they are: locked, written with the others, and walls for objects that grow after them.

Others are where objects begin: they grow from there onto the image, or give ground.</source>
        <translation>Les objets terminés restent tels quels : verrouillés, écrits avec les autres, et barrières pour les objets qui croissent après eux.

Avec les autres commencent des objets : ils croissent de là vers l’image, ou cèdent du terrain.</translation>
    </message>
    <message>
        <source>Reading the labels…</source>
        <translation>Lecture des étiquettes…</translation>
    </message>
    <message>
        <source>Segments that overlap</source>
        <translation>Segments qui se chevauchent</translation>
    </message>
    <message>
        <source>Segments may overlap here: voxels that several of those that are opened hold are left to the smallest of them.</source>
        <translation>Des segments peuvent se chevaucher ici : les voxels que contiennent plusieurs de ceux qui sont ouverts sont laissés au plus petit d’entre eux.</translation>
    </message>
    <message>
        <source>How the surfaces are made</source>
        <translation>Comment les surfaces sont faites</translation>
    </message>
    <message>
        <source>Only the largest &amp;part</source>
        <translation>Seulement la plus grande &amp;partie</translation>
    </message>
    <message>
        <source>Only the largest part</source>
        <translation>Seulement la plus grande partie</translation>
    </message>
    <message>
        <source>Of each label only the part with the most voxels: those that share a side</source>
        <translation>De chaque étiquette seulement la partie qui a le plus de voxels : ceux qui ont une face commune</translation>
    </message>
    <message>
        <source>&amp;Smoothing</source>
        <translation>&amp;Lissage</translation>
    </message>
    <message>
        <source>A voxel along each axis</source>
        <translation>Un voxel le long de chaque axe</translation>
    </message>
    <message>
        <source>A length</source>
        <translation>Une longueur</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>How far the steps between the voxels are smoothed, as a standard deviation. None: the surface goes midway between the voxels, steps and all.</source>
        <translation>Jusqu’où les marches entre les voxels sont lissées, en écart type. Aucun : la surface passe à mi-chemin entre les voxels, avec toutes les marches.</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Length of the smoothing</source>
        <translation>Longueur du lissage</translation>
    </message>
    <message>
        <source>Standard deviation; 0: none, steps and all</source>
        <translation>Écart type ; 0 : aucun, avec toutes les marches</translation>
    </message>
    <message>
        <source>No more &amp;tunnels than</source>
        <translation>Pas plus de tu&amp;nnels que</translation>
    </message>
    <message>
        <source>No more tunnels than</source>
        <translation>Pas plus de tunnels que</translation>
    </message>
    <message>
        <source>In each surface, all of its parts together: tunnels are filled, or what goes around them is cut, whichever changes the fewest voxels</source>
        <translation>Dans chaque surface, toutes ses parties ensemble : les tunnels sont comblés, ou ce qui les entoure est coupé, selon ce qui change le moins de voxels</translation>
    </message>
    <message>
        <source>Tunnels at most</source>
        <translation>Tunnels au plus</translation>
    </message>
    <message>
        <source>Tunnels, as in a ring</source>
        <translation>Tunnels, comme dans un anneau</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>&amp;Terminé</translation>
    </message>
    <message>
        <source>To &amp;grow from</source>
        <translation>Pour &amp;croître</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OpenPanel</name>
    <message>
        <source>along the patient's axes</source>
        <translation>le long des axes du patient</translation>
    </message>
    <message>
        <source>oblique: slices follow the volume's own axes</source>
        <translation>oblique : les coupes suivent les axes du volume</translation>
    </message>
    <message>
        <source>Open a CT, MR or ultrasound volume, a DICOM folder or a saved session; files can also be dropped on the window.</source>
        <translation>Ouvrez un volume CT, IRM ou échographique, un dossier DICOM ou une session enregistrée ; on peut aussi déposer des fichiers sur la fenêtre.</translation>
    </message>
    <message>
        <source>Series and stacks: choose one</source>
        <translation>Séries et piles : choisissez</translation>
    </message>
    <message>
        <source>Open this series</source>
        <translation>Ouvrir cette série</translation>
    </message>
    <message>
        <source>Open now</source>
        <translation>Ouvert</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Voxels</source>
        <translation>Voxels</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Espacement</translation>
    </message>
    <message>
        <source>Extent</source>
        <translation>Étendue</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Axes</source>
        <translation>Axes</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Avertissements</translation>
    </message>
    <message>
        <source>Time point</source>
        <translation>Instant</translation>
    </message>
    <message>
        <source>The volume has several time points; one is shown and segmented</source>
        <translation>Le volume a plusieurs instants ; un seul est montré et segmenté</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Charger</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>  (0 to %1)</source>
        <translation>  (0 à %1)</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::OverTimePanel</name>
    <message>
        <source>grown</source>
        <translation>crû</translation>
    </message>
    <message>
        <source>corrected, from frame %1</source>
        <translation>corrigé, depuis l’image %1</translation>
    </message>
    <message>
        <source>carried from frame %1</source>
        <translation>porté depuis l’image %1</translation>
    </message>
    <message>
        <source>⚠ %1</source>
        <translation>⚠ %1</translation>
    </message>
    <message>
        <source>✗ %1</source>
        <translation>✗ %1</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>ml</source>
        <translation>ml</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>What has become of each frame</source>
        <translation>Ce qu’est devenue chaque image</translation>
    </message>
    <message>
        <source>How far the surface is carried</source>
        <translation>Jusqu’où la surface est portée</translation>
    </message>
    <message>
        <source>State of what is carried</source>
        <translation>État de ce qui est porté</translation>
    </message>
    <message>
        <source>Figures over time</source>
        <translation>Chiffres au fil du temps</translation>
    </message>
    <message>
        <source>held</source>
        <translation>retenue</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>Topology over time</source>
        <translation>Topologie au fil du temps</translation>
    </message>
    <message>
        <source>Held: no frame has other components or tunnels than the first surface. Free: it may change.</source>
        <translation>Retenue : aucune image n’a d’autres composantes ou tunnels que la première surface. Libre : elle peut changer.</translation>
    </message>
    <message>
        <source>back</source>
        <translation>retour</translation>
    </message>
    <message>
        <source>round the cycle</source>
        <translation>tour du cycle</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>Check of the way</source>
        <translation>Contrôle du chemin</translation>
    </message>
    <message>
        <source>Back: carried back from the ends, to see how far it is off. Round the cycle: from the last frame to the first, which lie beside each other.</source>
        <translation>Retour : portée en arrière depuis les extrémités, pour voir l’écart. Tour du cycle : de la dernière image à la première, qui sont voisines.</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Première image</translation>
    </message>
    <message>
        <source>The surface is carried from here …</source>
        <translation>La surface est portée d’ici …</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Dernière image</translation>
    </message>
    <message>
        <source>… to here</source>
        <translation>… jusqu’ici</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>Topologie</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Contrôle</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>Check over time</source>
        <translation>Contrôle au fil du temps</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Plot…</source>
        <translation>Courbe…</translation>
    </message>
    <message>
        <source>Save the curve as CSV</source>
        <translation>Enregistrer la courbe en CSV</translation>
    </message>
    <message>
        <source>The same table as “handlebody-cli segment --curve F.csv” writes</source>
        <translation>Le même tableau que « handlebody-cli segment --curve F.csv » écrit</translation>
    </message>
    <message>
        <source>Save the curve as a plot</source>
        <translation>Enregistrer la courbe en image</translation>
    </message>
    <message>
        <source>The same picture (SVG) as “handlebody-cli segment --curve F.svg” writes</source>
        <translation>La même image (SVG) que « handlebody-cli segment --curve F.svg » écrit</translation>
    </message>
    <message>
        <source>Meshes…</source>
        <translation>Maillages…</translation>
    </message>
    <message>
        <source>Labels…</source>
        <translation>Étiquettes…</translation>
    </message>
    <message>
        <source>Save the volume over time</source>
        <translation>Enregistrer le volume au fil du temps</translation>
    </message>
    <message>
        <source>End-diastole %1 (frame %2), end-systole %3 (frame %4), stroke volume %5, &lt;b&gt;ejection fraction %6 %&lt;/b&gt;.</source>
        <translation>Télédiastole %1 (image %2), télésystole %3 (image %4), volume d’éjection %5, &lt;b&gt;fraction d’éjection %6 %&lt;/b&gt;.</translation>
    </message>
    <message>
        <source>From frame %1 back at frame %2: Dice %3, %4 off.</source>
        <translation>De l’image %1 au retour en image %2 : Dice %3, écart %4.</translation>
    </message>
    <message>
        <source>The surface was lost on its way from frame %1 back to frame %2.</source>
        <translation>La surface s’est perdue en chemin de l’image %1 vers l’image %2.</translation>
    </message>
    <message>
        <source>Frame %1 is being corrected: change it with clicks, walls and edits, then carry on from there.</source>
        <translation>L’image %1 est en cours de correction : modifiez-la avec des points, barrières et modifications, puis continuez à partir de là.</translation>
    </message>
    <message>
        <source>Carrying the surface through the frames…</source>
        <translation>La surface est portée à travers les images…</translation>
    </message>
    <message>
        <source>These are of an earlier surface of frame %1: carry it anew.</source>
        <translation>Celles-ci viennent d’une surface antérieure de l’image %1 : portez-la de nouveau.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::RulersPage</name>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete the chosen ruler or angle</source>
        <translation>Supprimer la règle ou l’angle choisi</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>Begins at (LPS)</source>
        <translation>Commence à (LPS)</translation>
    </message>
    <message>
        <source>Rulers and angles</source>
        <translation>Règles et angles</translation>
    </message>
    <message>
        <source>Places points in the slices or on the surface in 3D. Their ends can be dragged.</source>
        <translation>Place des points dans les coupes ou sur la surface en 3D. Leurs bouts peuvent être glissés.</translation>
    </message>
    <message>
        <source>Click where the ruler begins, or press Return for the crosshair.</source>
        <translation>Cliquez là où la règle commence, ou appuyez sur Entrée pour le réticule.</translation>
    </message>
    <message>
        <source>Click where it ends. Escape takes the beginning back.</source>
        <translation>Cliquez là où elle finit. Échap annule le début.</translation>
    </message>
    <message>
        <source>Click the end of one leg, or press Return for the crosshair.</source>
        <translation>Cliquez le bout d’un côté, ou appuyez sur Entrée pour le réticule.</translation>
    </message>
    <message>
        <source>Click where the legs meet. Escape takes the last point back.</source>
        <translation>Cliquez là où les côtés se rejoignent. Échap annule le dernier point.</translation>
    </message>
    <message>
        <source>Click the end of the other leg. Escape takes the last point back.</source>
        <translation>Cliquez le bout de l’autre côté. Échap annule le dernier point.</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Enregistrer en CSV…</translation>
    </message>
    <message>
        <source>Lengths in mm, angles in degrees and their points (mm, LPS) as a table</source>
        <translation>Longueurs en mm, angles en degrés et leurs points (mm, LPS) sous forme de tableau</translation>
    </message>
    <message>
        <source>Save as JSON…</source>
        <translation>Enregistrer en JSON…</translation>
    </message>
    <message>
        <source>The same as “handlebody-cli measure --json” writes of them</source>
        <translation>Ce que « handlebody-cli measure --json » en écrit</translation>
    </message>
    <message>
        <source>Save the rulers and angles</source>
        <translation>Enregistrer les règles et les angles</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SectionPlot</name>
    <message>
        <source>Area and equivalent diameter along the centre line</source>
        <translation>Aire et diamètre équivalent le long de la ligne centrale</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Area (mm²)</source>
        <translation>Aire (mm²)</translation>
    </message>
    <message>
        <source>Equivalent diameter (mm)</source>
        <translation>Diamètre équivalent (mm)</translation>
    </message>
    <message>
        <source>Area and equivalent diameter are plotted here along the line.</source>
        <translation>L’aire et le diamètre équivalent le long de la ligne sont tracés ici.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SeedPanel</name>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Radius of the selected seed. Automatic: the largest ball that fits into the object; outside of it, as the image allows</source>
        <translation>Rayon du germe choisi. Automatique : la plus grande boule qui tient dans l’objet ; hors de lui, selon ce que permet l’image</translation>
    </message>
    <message>
        <source>%1 (auto)</source>
        <translation>%1 (auto)</translation>
    </message>
    <message>
        <source>None yet: it takes a seed inside.</source>
        <translation>Aucun encore : il faut un germe à l’intérieur.</translation>
    </message>
    <message>
        <source>Given by the range in step 3, Tune.</source>
        <translation>Donné par l’intervalle à l’étape 3, Régler.</translation>
    </message>
    <message>
        <source>Looking for it…</source>
        <translation>Recherche…</translation>
    </message>
    <message>
        <source>Click into the structure in any slice, then press Return: a ball is placed there, from which the surface grows. One seed is often enough. Shift+Return marks a place outside. Drag a seed to move it, its rim to resize it.</source>
        <translation>Cliquez dans la structure dans une coupe, puis appuyez sur Entrée : une boule y est placée, d’où la surface grandit. Un germe suffit souvent. Maj+Entrée marque un endroit à l’extérieur. Glissez un germe pour le déplacer, son bord pour changer sa taille.</translation>
    </message>
    <message>
        <source>What is wrong with the seeds</source>
        <translation>Ce qui ne va pas avec les germes</translation>
    </message>
    <message>
        <source>Centre (mm LPS)</source>
        <translation>Centre (mm LPS)</translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation>Rayon (mm)</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Seeds</source>
        <translation>Germes</translation>
    </message>
    <message>
        <source>outside</source>
        <translation>dehors</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>dedans</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SensitivityPage</name>
    <message>
        <source>Run</source>
        <translation>Essai</translation>
    </message>
    <message>
        <source>Volume (ml)</source>
        <translation>Volume (ml)</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Composantes</translation>
    </message>
    <message>
        <source>Tunnels</source>
        <translation>Tunnels</translation>
    </message>
    <message>
        <source>Away (mm)</source>
        <translation>Écart (mm)</translation>
    </message>
    <message>
        <source>The perturbed runs</source>
        <translation>Les essais modifiés</translation>
    </message>
    <message>
        <source>Save the perturbed runs</source>
        <translation>Enregistrer les essais modifiés</translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation>Sensibilité</translation>
    </message>
    <message>
        <source>Grow the surface several times again, with clicks, smoothing and noise a little different: how much do volume and surface change?</source>
        <translation>Refaire croître la surface plusieurs fois, avec des points, un lissage et un bruit un peu différents : de combien changent le volume et la surface ?</translation>
    </message>
    <message>
        <source> runs</source>
        <translation> essais</translation>
    </message>
    <message>
        <source>Number of runs</source>
        <translation>Nombre d’essais</translation>
    </message>
    <message>
        <source>How often it is grown again; each takes about as long as the growth</source>
        <translation>Combien de fois elle croît de nouveau ; chaque fois dure à peu près autant que la croissance</translation>
    </message>
    <message>
        <source>Volume with its spread</source>
        <translation>Volume avec sa dispersion</translation>
    </message>
    <message>
        <source>State of the sensitivity</source>
        <translation>État de la sensibilité</translation>
    </message>
    <message>
        <source>How far it moves, in colour on the surface</source>
        <translation>De combien elle bouge, en couleur sur la surface</translation>
    </message>
    <message>
        <source>White where the surface is certain, red where it moves from run to run</source>
        <translation>Blanc où la surface est sûre, rouge où elle bouge d’un essai à l’autre</translation>
    </message>
    <message>
        <source>How many runs have ended</source>
        <translation>Combien d’essais sont terminés</translation>
    </message>
    <message>
        <source>Save as CSV…</source>
        <translation>Enregistrer en CSV…</translation>
    </message>
    <message>
        <source>Save the runs as CSV</source>
        <translation>Enregistrer les essais en CSV</translation>
    </message>
    <message>
        <source>Volume, topology and distance of every run</source>
        <translation>Volume, topologie et écart de chaque essai</translation>
    </message>
    <message>
        <source>moves by</source>
        <translation>bouge de</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>%1 ± %2 ml</source>
        <translation>%1 ± %2 ml</translation>
    </message>
    <message>
        <source>%1 to %2 in %3 of %4 runs, %5 of the same topology. The surface moves by %6, 95 % of it by less than %7.</source>
        <translation>%1 à %2 dans %3 essais sur %4, %5 de même topologie. La surface bouge de %6, dont 95 % de moins de %7.</translation>
    </message>
    <message>
        <source> ⚠ %1.</source>
        <translation> ⚠ %1.</translation>
    </message>
    <message>
        <source>None of the runs left a surface.</source>
        <translation>Aucun des essais n’a laissé de surface.</translation>
    </message>
    <message>
        <source>Growing it again…</source>
        <translation>Nouvelle croissance…</translation>
    </message>
    <message>
        <source>These are figures of an earlier surface, or of another object.</source>
        <translation>Ces indices sont ceux d’une surface antérieure ou d’un autre objet.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SeriesList</name>
    <message>
        <source>, stack %1</source>
        <translation>, pile %1</translation>
    </message>
    <message>
        <source>No volume: %1</source>
        <translation>Pas de volume : %1</translation>
    </message>
    <message>
        <source>%1, %2 mm</source>
        <translation>%1, %2 mm</translation>
    </message>
    <message>
        <source>Slices: %1</source>
        <translation>Coupes : %1</translation>
    </message>
    <message>
        <source>Files: %1</source>
        <translation>Fichiers : %1</translation>
    </message>
    <message>
        <source> · time points: %1</source>
        <translation> · instants : %1</translation>
    </message>
    <message>
        <source>Series in the folder</source>
        <translation>Séries du dossier</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SliceView</name>
    <message>
        <source>%1, oblique</source>
        <translation>%1, oblique</translation>
    </message>
    <message>
        <source>W %1  L %2</source>
        <translation>F %1  N %2</translation>
    </message>
    <message>
        <source>no edge in the image</source>
        <translation>aucun contour dans l’image</translation>
    </message>
    <message>
        <source>pinned</source>
        <translation>fixé</translation>
    </message>
    <message>
        <source>Open a volume: Ctrl+O,
or drop a file here</source>
        <translation>Ouvrir un volume : Ctrl+O,
ou déposer un fichier ici</translation>
    </message>
    <message>
        <source>%1 slice</source>
        <translation>Coupe %1</translation>
    </message>
    <message>
        <source>Arrows and Page Up or Down move the crosshair, Return adds a seed, Shift and Return a click outside of the object, W changes window and level. B and E turn the brush for walls on and off, with Shift they paint and erase at the crosshair; L pins with it, Shift and L unpins, M smooths, U pulls.</source>
        <translation>Les flèches et Page préc. ou suiv. déplacent le réticule, Entrée ajoute un germe, Maj et Entrée un point extérieur, W change fenêtre et niveau. B et E activent ou non le pinceau des barrières, avec Maj ils peignent et effacent au réticule ; L fixe, Maj et L libère, M lisse, U tire.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SpacingEntry</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Distance between the middles of neighbouring voxels</source>
        <translation>Distance entre les milieux de voxels voisins</translation>
    </message>
    <message>
        <source>Size of a voxel</source>
        <translation>Taille d’un voxel</translation>
    </message>
    <message>
        <source>The file does not give it. Lengths and volumes are right only with the true spacing along columns, rows and slices.</source>
        <translation>Le fichier ne la donne pas. Longueurs et volumes ne sont justes qu’avec le vrai espacement des colonnes, lignes et coupes.</translation>
    </message>
    <message>
        <source>Spacing of columns</source>
        <translation>Espacement des colonnes</translation>
    </message>
    <message>
        <source>Spacing of rows</source>
        <translation>Espacement des lignes</translation>
    </message>
    <message>
        <source>Spacing of slices</source>
        <translation>Espacement des coupes</translation>
    </message>
    <message>
        <source>Open with this spacing</source>
        <translation>Ouvrir avec cet espacement</translation>
    </message>
    <message>
        <source>File without a spacing</source>
        <translation>Fichier sans espacement</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StartPage</name>
    <message>
        <source>Open a volume to begin</source>
        <translation>Ouvrez un volume pour commencer</translation>
    </message>
    <message>
        <source>Drop a CT, MR or ultrasound volume here, or choose one.</source>
        <translation>Déposez ici un volume CT, IRM ou échographique, ou choisissez-en un.</translation>
    </message>
    <message>
        <source>Try the ultrasound sample</source>
        <translation>Essayer l’exemple échographique</translation>
    </message>
    <message>
        <source>A simulated cyst with a needle through it, with its seed placed</source>
        <translation>Un kyste simulé traversé par une aiguille, avec son germe placé</translation>
    </message>
    <message>
        <source>Opened before</source>
        <translation>Déjà ouverts</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Ouvrir %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StatusFields</name>
    <message>
        <source>Position of the mouse, mm LPS</source>
        <translation>Position de la souris, mm LPS</translation>
    </message>
    <message>
        <source>Voxel under the mouse</source>
        <translation>Voxel sous la souris</translation>
    </message>
    <message>
        <source>Voxel %1</source>
        <translation>Voxel %1</translation>
    </message>
    <message>
        <source>Intensity of the voxel</source>
        <translation>Intensité du voxel</translation>
    </message>
    <message>
        <source>Intensity %1</source>
        <translation>Intensité %1</translation>
    </message>
    <message>
        <source>Uncalibrated</source>
        <translation>Non calibré</translation>
    </message>
    <message>
        <source>State of the growth</source>
        <translation>État de la croissance</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stop reading the volume; what is open stays open</source>
        <translation>Arrêter la lecture du volume ; ce qui est ouvert le reste</translation>
    </message>
    <message>
        <source>The file does not give the size of a voxel: lengths, areas and volumes mean nothing until it is entered in step 1, Open</source>
        <translation>Le fichier ne donne pas la taille d’un voxel : longueurs, aires et volumes ne signifient rien tant qu’elle n’est pas saisie à l’étape 1, Ouvrir</translation>
    </message>
    <message>
        <source>Nothing is open</source>
        <translation>Rien n’est ouvert</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>Lecture de %1…</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::StepsPanel</name>
    <message>
        <source>Step %1</source>
        <translation>Étape %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::SurfaceView</name>
    <message>
        <source>This machine offers no OpenGL 3.2: the surface cannot be shown in 3D. Slices, growth and export work all the same.</source>
        <translation>Cette machine n’offre pas OpenGL 3.2 : la surface ne peut être montrée en 3D. Coupes, croissance et export fonctionnent quand même.</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>The surface grows here</source>
        <translation>La surface grandit ici</translation>
    </message>
    <message>
        <source>Nothing is left of the surface</source>
        <translation>Il ne reste rien de la surface</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>Home, End and Page Down look from superior, anterior and left. With the brush on, left pins, unpins, smooths or pulls the surface.</source>
        <translation>Origine, Fin et Page suiv. regardent de dessus, de face et de gauche. Pinceau actif, le bouton gauche fixe, libère, lisse ou tire la surface.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimeBar</name>
    <message>
        <source>Frame %1 of 0–%2</source>
        <translation>Image %1 sur 0–%2</translation>
    </message>
    <message>
        <source>%1, %2 ms</source>
        <translation>%1, %2 ms</translation>
    </message>
    <message>
        <source>Shown frame</source>
        <translation>Image affichée</translation>
    </message>
    <message>
        <source>What is wrong with the shown frame</source>
        <translation>Ce qui ne va pas dans l’image affichée</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>Lecture…</translation>
    </message>
    <message>
        <source>The surface is grown in this frame</source>
        <translation>La surface a crû dans cette image</translation>
    </message>
    <message>
        <source>The surface has not been carried here</source>
        <translation>La surface n’a pas été portée ici</translation>
    </message>
    <message>
        <source>The surface here was carried from an earlier state of frame %1: carry it again.</source>
        <translation>La surface ici a été portée depuis un état antérieur de l’image %1 : portez-la de nouveau.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelinePanel</name>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
    </message>
    <message>
        <source>Changes of topology are listed here.</source>
        <translation>Les changements de topologie sont listés ici.</translation>
    </message>
    <message>
        <source>Show repairs of the mesh, too</source>
        <translation>Montrer aussi les réparations du maillage</translation>
    </message>
    <message>
        <source>&lt;p&gt;Folds that were smoothed away, and parts of the surface whose step would have left an invalid mesh and that returned to where they were. The topology is the same before and after.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Plis qui ont été lissés, et parties de la surface dont le pas aurait laissé un maillage invalide et qui sont revenues où elles étaient. La topologie est la même avant et après.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelinePlot</name>
    <message>
        <source>Leak: %1</source>
        <translation>Fuite : %1</translation>
    </message>
    <message>
        <source>Volume and moving share over the iterations</source>
        <translation>Volume et part en mouvement au fil des itérations</translation>
    </message>
    <message>
        <source>Iteration %1: %2, %3 % of the vertices moving, %4</source>
        <translation>Itération %1 : %2, %3 % des sommets en mouvement, %4</translation>
    </message>
    <message>
        <source>events: %1</source>
        <translation>événements : %1</translation>
    </message>
    <message>
        <source>Volume, up to %1</source>
        <translation>Volume, jusqu’à %1</translation>
    </message>
    <message>
        <source>Moving, 0 to 100 %</source>
        <translation>En mouvement, 0 à 100 %</translation>
    </message>
    <message>
        <source>Volume and motion are plotted here while the surface grows.</source>
        <translation>Volume et mouvement sont tracés ici pendant que la surface grandit.</translation>
    </message>
    <message>
        <source>Changed at %1: %2</source>
        <translation>Modifié à %1 : %2</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TimelineSlider</name>
    <message>
        <source>Iteration</source>
        <translation>Itération</translation>
    </message>
    <message>
        <source>&lt;p&gt;Iterations; diamonds are changes of topology, strokes below the line places that were rolled back. Click or drag to go there.&lt;/p&gt;</source>
        <translation>&lt;p&gt;Itérations ; les losanges sont des changements de topologie, les traits sous la ligne des endroits ramenés en arrière. Cliquer ou glisser pour y aller.&lt;/p&gt;</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TopologySection</name>
    <message>
        <source>Held at iteration %1: %2.</source>
        <translation>Retenu à l’itération %1 : %2.</translation>
    </message>
    <message>
        <source>any</source>
        <translation>libre</translation>
    </message>
    <message>
        <source>Topology</source>
        <translation>Topologie</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>Never more than</source>
        <translation>Jamais plus de</translation>
    </message>
    <message>
        <source>Ask each time</source>
        <translation>Demander à chaque fois</translation>
    </message>
    <message>
        <source>What happens where the surface would get more parts or tunnels than are chosen: it gets them, never does (what is held is listed in Correct), or the growth pauses and asks you</source>
        <translation>Ce qui se passe là où la surface aurait plus de parties ou de tunnels que choisi : elle les a, jamais (ce qui est retenu est listé dans Corriger), ou la croissance s’arrête et vous demande</translation>
    </message>
    <message>
        <source>Components at most</source>
        <translation>Composantes au plus</translation>
    </message>
    <message>
        <source>Connected parts of the surface, cavities included</source>
        <translation>Parties connexes de la surface, cavités comprises</translation>
    </message>
    <message>
        <source>Genus at most</source>
        <translation>Genre au plus</translation>
    </message>
    <message>
        <source>Tunnels, as in a ring, of all parts together</source>
        <translation>Tunnels, comme dans un anneau, de toutes les parties ensemble</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parties</translation>
    </message>
    <message>
        <source>Genus</source>
        <translation>Genre</translation>
    </message>
    <message>
        <source>To decide</source>
        <translation>À décider</translation>
    </message>
    <message>
        <source>Let it happen</source>
        <translation>Laisser faire</translation>
    </message>
    <message>
        <source>It may break the limits here; the growth goes on</source>
        <translation>Elle peut dépasser les limites ici ; la croissance continue</translation>
    </message>
    <message>
        <source>Hold it</source>
        <translation>Retenir</translation>
    </message>
    <message>
        <source>It stays held here, and you are not asked again; the growth goes on</source>
        <translation>Cela reste retenu ici et on ne vous redemande pas ; la croissance continue</translation>
    </message>
    <message>
        <source>Free topology</source>
        <translation>Libérer la topologie</translation>
    </message>
    <message>
        <source>Ask about the topology</source>
        <translation>Demander pour la topologie</translation>
    </message>
    <message>
        <source>Limit the topology</source>
        <translation>Limiter la topologie</translation>
    </message>
    <message>
        <source>%1 more to decide.</source>
        <translation>Encore %1 à décider.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TouchSection</name>
    <message>
        <source>Pin</source>
        <translation>Fixer</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Libérer</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Pull</source>
        <translation>Tirer</translation>
    </message>
    <message>
        <source>Cut line</source>
        <translation>Couper une ligne</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Number of pins</source>
        <translation>Nombre de fixations</translation>
    </message>
    <message>
        <source>Nothing is pinned.</source>
        <translation>Rien n’est fixé.</translation>
    </message>
    <message>
        <source>Balls pinned: %1</source>
        <translation>Boules fixées : %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TunePanel</name>
    <message>
        <source>What is wrong with the parameters</source>
        <translation>Ce qui ne va pas avec les paramètres</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objet</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Bright</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>The object is darker than its surroundings</source>
        <translation>L’objet est plus sombre que son entourage</translation>
    </message>
    <message>
        <source>The object is brighter than its surroundings</source>
        <translation>L’objet est plus clair que son entourage</translation>
    </message>
    <message>
        <source>Found out from the image around the seeds</source>
        <translation>Déterminé d’après l’image autour des germes</translation>
    </message>
    <message>
        <source>Change object</source>
        <translation>Modifier l’objet</translation>
    </message>
    <message>
        <source>Intensities from the lower to the upper end belong to the object</source>
        <translation>Les intensités de la borne inférieure à la supérieure appartiennent à l’objet</translation>
    </message>
    <message>
        <source>Intensities of the object</source>
        <translation>Intensités de l’objet</translation>
    </message>
    <message>
        <source>Lowest intensity of the object</source>
        <translation>Plus basse intensité de l’objet</translation>
    </message>
    <message>
        <source>Highest intensity of the object</source>
        <translation>Plus haute intensité de l’objet</translation>
    </message>
    <message>
        <source>Range: automatic</source>
        <translation>Intervalle : automatique</translation>
    </message>
    <message>
        <source>Chosen from the image around the seeds</source>
        <translation>Choisi d’après l’image autour des germes</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>Change range</source>
        <translation>Changer l’intervalle</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>Changer le lissage</translation>
    </message>
    <message>
        <source>Change edge length</source>
        <translation>Changer la longueur d’arête</translation>
    </message>
    <message>
        <source>Change balloon</source>
        <translation>Changer le ballon</translation>
    </message>
    <message>
        <source>Change curvature</source>
        <translation>Changer la courbure</translation>
    </message>
    <message>
        <source>Change iteration limit</source>
        <translation>Changer la limite d’itérations</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Sens</translation>
    </message>
    <message>
        <source>Outward</source>
        <translation>Expansion</translation>
    </message>
    <message>
        <source>Both</source>
        <translation>Les deux</translation>
    </message>
    <message>
        <source>The surface only grows</source>
        <translation>La surface ne fait que grandir</translation>
    </message>
    <message>
        <source>The surface may also shrink</source>
        <translation>La surface peut aussi rétrécir</translation>
    </message>
    <message>
        <source>Change direction</source>
        <translation>Changer le sens</translation>
    </message>
    <message>
        <source>Expert</source>
        <translation>Expert</translation>
    </message>
    <message>
        <source>Collisions</source>
        <translation>Collisions</translation>
    </message>
    <message>
        <source>Sorted</source>
        <translation>Tri</translation>
    </message>
    <message>
        <source>Hashing</source>
        <translation>Hachage</translation>
    </message>
    <message>
        <source>Near vertices are found in one sorted table. The surface does not depend on it</source>
        <translation>Les sommets proches sont trouvés dans une table triée. La surface n’en dépend pas</translation>
    </message>
    <message>
        <source>Near vertices are found by the paper's eight hash functions: slower, the same surface</source>
        <translation>Les sommets proches sont trouvés par les huit fonctions de hachage de l’article : plus lent, même surface</translation>
    </message>
    <message>
        <source>Change search for collisions</source>
        <translation>Changer la recherche de collisions</translation>
    </message>
    <message>
        <source>%1 everything here is then chosen from the image. Change it only if the surface leaks or stops early.</source>
        <translation>%1 tout ce qui est ici est alors choisi d’après l’image. Ne le changez que si la surface fuit ou s’arrête tôt.</translation>
    </message>
    <message>
        <source>Place a seed:</source>
        <translation>Placez un germe :</translation>
    </message>
    <message>
        <source>Open a volume and place a seed:</source>
        <translation>Ouvrez un volume et placez un germe :</translation>
    </message>
    <message>
        <source>Auto (dark)</source>
        <translation>Auto (sombre)</translation>
    </message>
    <message>
        <source>Auto (bright)</source>
        <translation>Auto (clair)</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>Uniformes</translation>
    </message>
    <message>
        <source>Adaptive</source>
        <translation>Adaptées</translation>
    </message>
    <message>
        <source>The target edge length is the same everywhere</source>
        <translation>La longueur d’arête visée est partout la même</translation>
    </message>
    <message>
        <source>Edges and steps are up to four times as long where the image shows no boundary near by: fewer iterations</source>
        <translation>Arêtes et pas jusqu’à quatre fois plus longs là où l’image ne montre pas de limite proche : moins d’itérations</translation>
    </message>
    <message>
        <source>Change edges</source>
        <translation>Modifier les arêtes</translation>
    </message>
    <message>
        <source>Tint the object in the slices</source>
        <translation>Teinter l’objet dans les coupes</translation>
    </message>
    <message>
        <source>The voxels that the surface is driven into: as smoothed, up to necks that are cut and to walls. They are tinted for a moment after every change; with this on, all the time</source>
        <translation>Les voxels vers lesquels la surface est poussée : lissés, jusqu’aux cols coupés et aux parois. Ils sont teintés un instant après chaque modification ; coché, en permanence</translation>
    </message>
    <message>
        <source>Adaptive where the object is wide for its edges, so that this saves iterations</source>
        <translation>Adaptative là où l’objet est assez large pour ses arêtes pour économiser des itérations</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::TunnelsList</name>
    <message>
        <source>Component removed</source>
        <translation>Composante retirée</translation>
    </message>
    <message>
        <source>One component kept</source>
        <translation>Une composante gardée</translation>
    </message>
    <message>
        <source>Cavity filled</source>
        <translation>Cavité remplie</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Lissé</translation>
    </message>
    <message>
        <source>Pulled</source>
        <translation>Tiré</translation>
    </message>
    <message>
        <source>Cut by a plane</source>
        <translation>Coupé par un plan</translation>
    </message>
    <message>
        <source>Handle cut</source>
        <translation>Anse coupée</translation>
    </message>
    <message>
        <source>Tunnel filled</source>
        <translation>Tunnel rempli</translation>
    </message>
    <message>
        <source>Tunnel closed</source>
        <translation>Tunnel fermé</translation>
    </message>
    <message>
        <source>What the surface holds</source>
        <translation>Ce que contient la surface</translation>
    </message>
    <message>
        <source>The chosen row</source>
        <translation>La ligne choisie</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Quoi</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Tunnels, components and cavities, each with its size</source>
        <translation>Tunnels, composantes et cavités, avec leur taille</translation>
    </message>
    <message>
        <source>Cut handle</source>
        <translation>Couper l’anse</translation>
    </message>
    <message>
        <source>Cuts along the loop around the handle, which goes; both ends get a cap</source>
        <translation>Coupe le long de la boucle autour de l’anse, qui disparaît ; les deux bouts reçoivent un couvercle</translation>
    </message>
    <message>
        <source>Fill tunnel</source>
        <translation>Remplir le tunnel</translation>
    </message>
    <message>
        <source>Cuts along the loop round the tunnel: a membrane closes it on both sides</source>
        <translation>Coupe le long de la boucle autour du tunnel : une membrane le ferme des deux côtés</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Removes this component with all that lies in it</source>
        <translation>Retire cette composante avec tout ce qu’elle contient</translation>
    </message>
    <message>
        <source>Keep only this</source>
        <translation>Ne garder que cela</translation>
    </message>
    <message>
        <source>Removes everything but this component and its cavities</source>
        <translation>Retire tout sauf cette composante et ses cavités</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>Remplir</translation>
    </message>
    <message>
        <source>Fills this cavity, with all that lies in it</source>
        <translation>Remplit cette cavité, avec tout ce qu’elle contient</translation>
    </message>
    <message>
        <source>Leave out</source>
        <translation>Omettre</translation>
    </message>
    <message>
        <source>Goes back to the step before this edit, and on without it</source>
        <translation>Revient au pas d’avant cette retouche, et continue sans elle</translation>
    </message>
    <message>
        <source>Tunnel</source>
        <translation>Tunnel</translation>
    </message>
    <message>
        <source>%1 around its handle, %2 round the tunnel</source>
        <translation>%1 autour de l’anse, %2 autour du tunnel</translation>
    </message>
    <message>
        <source>; knotted</source>
        <translation> ; noué</translation>
    </message>
    <message>
        <source>Cavity</source>
        <translation>Cavité</translation>
    </message>
    <message>
        <source>Component</source>
        <translation>Composante</translation>
    </message>
    <message>
        <source>%1 mm, genus %2</source>
        <translation>%1 mm, genre %2</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>pas %1</translation>
    </message>
    <message>
        <source>At %1</source>
        <translation>À %1</translation>
    </message>
    <message>
        <source>Looking…</source>
        <translation>Recherche…</translation>
    </message>
    <message>
        <source>Tunnels: %1</source>
        <translation>Tunnels : %1</translation>
    </message>
    <message>
        <source>components: %1</source>
        <translation>composantes : %1</translation>
    </message>
    <message>
        <source>cavities: %1</source>
        <translation>cavités : %1</translation>
    </message>
    <message>
        <source>tunnels without loops: %1</source>
        <translation>tunnels sans boucles : %1</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Find tunnels and pieces</source>
        <translation>Chercher tunnels et morceaux</translation>
    </message>
    <message>
        <source>Lists the tunnels, components and cavities of the shown surface</source>
        <translation>Liste les tunnels, composantes et cavités de la surface montrée</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ValueField</name>
    <message>
        <source>Reset %1</source>
        <translation>Réinitialiser %1</translation>
    </message>
    <message>
        <source>Back to the usual value, %1</source>
        <translation>Retour à la valeur habituelle, %1</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>%1: automatic</source>
        <translation>%1 : automatique</translation>
    </message>
    <message>
        <source>The value is chosen from the image around the seeds</source>
        <translation>La valeur est choisie d’après l’image autour des germes</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ViewFrame</name>
    <message>
        <source>Show all four views (double click)</source>
        <translation>Montrer les quatre vues (double clic)</translation>
    </message>
    <message>
        <source>Let this view fill the window (double click)</source>
        <translation>Cette vue remplit la fenêtre (double clic)</translation>
    </message>
    <message>
        <source>Show all four views</source>
        <translation>Montrer les quatre vues</translation>
    </message>
    <message>
        <source>Maximise the %1 view</source>
        <translation>Agrandir la vue %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::ViewGrid</name>
    <message>
        <source>Axial</source>
        <translation>Axiale</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Coronale</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittale</translation>
    </message>
    <message>
        <source>3D</source>
        <translation>3D</translation>
    </message>
    <message>
        <source>%1 view</source>
        <translation>Vue %1</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::VolumePlot</name>
    <message>
        <source>Volume over time</source>
        <translation>Volume au fil du temps</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Volume (ml) over time (ms)</source>
        <translation>Volume (ml) au fil du temps (ms)</translation>
    </message>
    <message>
        <source>Volume (ml) over frames</source>
        <translation>Volume (ml) par image</translation>
    </message>
    <message>
        <source>end-diastole</source>
        <translation>télédiastole</translation>
    </message>
    <message>
        <source>end-systole</source>
        <translation>télésystole</translation>
    </message>
    <message>
        <source>The volume over time is plotted here when the surface is carried through the frames.</source>
        <translation>Le volume au fil du temps est tracé ici quand la surface est portée à travers les images.</translation>
    </message>
</context>
<context>
    <name>handlebody::ui::WallSection</name>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Number of walls</source>
        <translation>Nombre de barrières</translation>
    </message>
    <message>
        <source>Nothing is painted.</source>
        <translation>Rien n’est peint.</translation>
    </message>
    <message>
        <source>Balls painted: %1</source>
        <translation>Boules peintes : %1</translation>
    </message>
</context>
</TS>
